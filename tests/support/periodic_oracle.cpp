#include "support/periodic_oracle.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace abut::testing {
namespace {

mpq_class image_distance_squared(const scenes::Scene& scene, const Domain& domain, std::size_t i,
                                 std::size_t j, const ImageShift& shift) {
  const std::vector<double>* columns[] = {&scene.x, &scene.y, &scene.z};
  const std::int32_t numbers[] = {shift.x, shift.y, shift.z};
  mpq_class sum = 0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
    mpq_class difference = mpq_class((*columns[axis])[i]) - mpq_class((*columns[axis])[j]);
    for (int k = 0; k < 3; ++k) {
      if (numbers[k] != 0) difference -= numbers[k] * mpq_class(domain.vector(k)[axis]);
    }
    sum += difference * difference;
  }
  return sum;
}

/// Whether an image is so far away that rounding, of 2^-48 at the most here, cannot matter.
bool clearly_apart(const scenes::Scene& scene, const Domain& domain, std::size_t i, std::size_t j,
                   const ImageShift& shift, double margin) {
  const std::vector<double>* columns[] = {&scene.x, &scene.y, &scene.z};
  const std::int32_t numbers[] = {shift.x, shift.y, shift.z};
  double sum = 0.0;
  double magnitude = 1.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
    double difference = (*columns[axis])[i] - (*columns[axis])[j];
    for (int k = 0; k < 3; ++k) difference -= numbers[k] * domain.vector(k)[axis];
    sum += difference * difference;
    magnitude += std::abs((*columns[axis])[i]) + std::abs(difference);
  }
  const double reach = scene.radius[i] + scene.radius[j] + margin + 1e-9 * magnitude;
  return sum > reach * reach;
}

}  // namespace

std::vector<ImagePair> oracle_image_pairs(const scenes::Scene& scene, const Domain& domain,
                                          double margin, std::int32_t farthest) {
  std::vector<ImageShift> shifts;
  const auto end = [&](int axis) { return domain.is_periodic(axis) ? farthest : 0; };
  for (std::int32_t x = -end(0); x <= end(0); ++x) {
    for (std::int32_t y = -end(1); y <= end(1); ++y) {
      for (std::int32_t z = -end(2); z <= end(2); ++z) shifts.push_back({x, y, z});
    }
  }
  std::vector<ImagePair> result;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    for (std::size_t j = i; j < scene.size(); ++j) {
      const mpq_class reach =
          mpq_class(scene.radius[i]) + mpq_class(scene.radius[j]) + mpq_class(margin);
      for (const ImageShift& n : shifts) {
        if (i == j && n <= ImageShift{}) continue;
        if (clearly_apart(scene, domain, i, j, n, margin)) continue;
        if (image_distance_squared(scene, domain, i, j, n) > reach * reach) continue;
        EXPECT_LT(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), farthest)
            << "the oracle looks not far enough";
        result.push_back({{static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)}, n});
      }
    }
  }
  return result;
}

}  // namespace abut::testing
