#include "support/periodic_oracle.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace abut::testing {
namespace {

/// n A on an axis.
mpq_class moved_by(const Domain& domain, const ImageShift& shift, std::size_t axis) {
  const std::int32_t numbers[] = {shift.x, shift.y, shift.z};
  mpq_class moved = 0;
  for (int k = 0; k < 3; ++k) {
    if (numbers[k] != 0) moved += numbers[k] * mpq_class(domain.vector(k)[axis]);
  }
  return moved;
}

/// The same, rounded.
double moved_nearly_by(const Domain& domain, const ImageShift& shift, std::size_t axis) {
  const std::int32_t numbers[] = {shift.x, shift.y, shift.z};
  double moved = 0.0;
  for (int k = 0; k < 3; ++k) {
    if (numbers[k] != 0) moved += numbers[k] * domain.vector(k)[axis];
  }
  return moved;
}

class Spheres {
 public:
  Spheres(const scenes::Scene& scene, const Domain& domain, double margin)
      : scene_(scene), domain_(domain), margin_(margin) {}

  [[nodiscard]] std::size_t size() const { return scene_.size(); }

  [[nodiscard]] bool within_reach(std::size_t i, std::size_t j, const ImageShift& shift) const {
    mpq_class square = 0;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const mpq_class difference = mpq_class((*columns_[axis])[i]) -
                                   mpq_class((*columns_[axis])[j]) - moved_by(domain_, shift, axis);
      square += difference * difference;
    }
    const mpq_class reach =
        mpq_class(scene_.radius[i]) + mpq_class(scene_.radius[j]) + mpq_class(margin_);
    return square <= reach * reach;
  }

  /// Whether an image is so far away that rounding, of 2^-48 at the most here, cannot matter.
  [[nodiscard]] bool clearly_apart(std::size_t i, std::size_t j, const ImageShift& shift) const {
    double sum = 0.0;
    double magnitude = 1.0;
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const double difference =
          (*columns_[axis])[i] - (*columns_[axis])[j] - moved_nearly_by(domain_, shift, axis);
      sum += difference * difference;
      magnitude += std::abs((*columns_[axis])[i]) + std::abs(difference);
    }
    const double reach = scene_.radius[i] + scene_.radius[j] + margin_ + 1e-9 * magnitude;
    return sum > reach * reach;
  }

 private:
  [[nodiscard]] std::size_t axes() const { return static_cast<std::size_t>(scene_.dimensions); }

  const scenes::Scene& scene_;
  const Domain& domain_;
  double margin_;
  std::array<const std::vector<double>*, 3> columns_{&scene_.x, &scene_.y, &scene_.z};
};

class Boxes {
 public:
  Boxes(const scenes::BoxScene& scene, const Domain& domain, double margin)
      : scene_(scene), domain_(domain), margin_(margin) {}

  [[nodiscard]] std::size_t size() const { return scene_.size(); }

  [[nodiscard]] bool within_reach(std::size_t i, std::size_t j, const ImageShift& shift) const {
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const mpq_class moved = moved_by(domain_, shift, axis);
      const auto& lower = scene_.lower[axis];
      const auto& upper = scene_.upper[axis];
      if (mpq_class(lower[i]) > mpq_class(upper[j]) + moved + mpq_class(margin_)) return false;
      if (mpq_class(lower[j]) + moved > mpq_class(upper[i]) + mpq_class(margin_)) return false;
    }
    return true;
  }

  [[nodiscard]] bool clearly_apart(std::size_t i, std::size_t j, const ImageShift& shift) const {
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      const double moved = moved_nearly_by(domain_, shift, axis);
      const auto& lower = scene_.lower[axis];
      const auto& upper = scene_.upper[axis];
      const double apart = std::max(lower[i] - upper[j] - moved, lower[j] - upper[i] + moved);
      const double magnitude =
          1.0 + std::abs(lower[i]) + std::abs(lower[j]) + std::abs(upper[i]) + std::abs(moved);
      if (apart > margin_ + 1e-9 * magnitude) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] std::size_t axes() const { return static_cast<std::size_t>(scene_.dimensions); }

  const scenes::BoxScene& scene_;
  const Domain& domain_;
  double margin_;
};

template <class Elements>
std::vector<ImagePair> all_pairs(const Elements& elements, const Domain& domain,
                                 std::int32_t farthest) {
  std::vector<ImageShift> shifts;
  const auto end = [&](int axis) { return domain.is_periodic(axis) ? farthest : 0; };
  for (std::int32_t x = -end(0); x <= end(0); ++x) {
    for (std::int32_t y = -end(1); y <= end(1); ++y) {
      for (std::int32_t z = -end(2); z <= end(2); ++z) shifts.push_back({x, y, z});
    }
  }
  std::vector<ImagePair> result;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (std::size_t j = i; j < elements.size(); ++j) {
      for (const ImageShift& n : shifts) {
        if (i == j && n <= ImageShift{}) continue;
        if (elements.clearly_apart(i, j, n) || !elements.within_reach(i, j, n)) continue;
        EXPECT_LT(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), farthest)
            << "the oracle looks not far enough";
        result.push_back({{static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)}, n});
      }
    }
  }
  return result;
}

}  // namespace

std::vector<ImagePair> oracle_image_pairs(const scenes::Scene& scene, const Domain& domain,
                                          double margin, std::int32_t farthest) {
  return all_pairs(Spheres(scene, domain, margin), domain, farthest);
}

std::vector<ImagePair> oracle_image_pairs(const scenes::BoxScene& scene, const Domain& domain,
                                          double margin, std::int32_t farthest) {
  return all_pairs(Boxes(scene, domain, margin), domain, farthest);
}

}  // namespace abut::testing
