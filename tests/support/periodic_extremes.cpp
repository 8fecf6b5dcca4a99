#include "support/periodic_extremes.hpp"

#include "scenes/random.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using Vector = Domain::Vector;

bool applies(Extreme extreme, Extreme to) {
  if (extreme == to) return true;
  return extreme == Extreme::stray_and_scale && (to == Extreme::stray || to == Extreme::scale);
}

/// A system in the making: numbers near 1.
class Maker {
 public:
  Maker(DomainKind kind, Extreme extreme, int dimensions, std::size_t count, std::uint64_t seed)
      : kind_(kind),
        extreme_(extreme),
        axes_(static_cast<std::size_t>(dimensions)),
        count_(count),
        random_(seed) {}

  ExtremeSystem make() {
    choose_vectors();
    choose_radii();
    for (std::size_t k = 0; k < count_; ++k) points_.push_back(point());
    if (extreme_ == Extreme::flat) flatten();
    if (extreme_ == Extreme::far_cells) move_by_cells();
    if (applies(extreme_, Extreme::stray)) send_astray();
    const int exponent = applies(extreme_, Extreme::scale) ? choose_scale() : 0;
    return scaled(exponent);
  }

 private:
  /// A multiple of 1/64 or anything, in [0, 1).
  double fraction() {
    return random_.below(3) > 0 ? static_cast<double>(random_.below(64)) / 64.0 : random_.uniform();
  }

  int exponent_of(std::initializer_list<int> exponents) {
    return exponents.begin()[random_.below(exponents.size())];
  }

  void set_length(std::size_t axis, double length) { vectors_[axis][axis] = length; }

  void choose_vectors() {
    for (std::size_t axis = 0; axis < axes_; ++axis)
      set_length(axis, random_.below(2) ? 1.0 : 1.25);
    const std::size_t first = random_.below(axes_);
    switch (kind_) {
      case DomainKind::open:
        return;
      case DomainKind::one_axis:
        periodic_[first] = true;
        return;
      case DomainKind::two_axes:
        for (std::size_t axis = 0; axis < axes_; ++axis)
          periodic_[axis] = axes_ == 2 || axis != first;
        return;
      case DomainKind::small_cell:
        periodic_[first] = true;
        if (random_.below(2) > 0) periodic_[random_.below(axes_)] = true;
        set_length(first, std::ldexp(1.0, exponent_of({-4, -6, -8})));
        return;
      case DomainKind::one_oblique:
        periodic_[0] = true;
        vectors_[0] = {0.6, 0.7, axes_ == 3 ? -0.4 : 0.0};
        return;
      default:
        choose_full_vectors(first);
    }
  }

  void choose_full_vectors(std::size_t first) {
    periodic_.fill(true);
    periodic_[2] = axes_ == 3;
    if (kind_ == DomainKind::lees_edwards) {
      vectors_[1][0] = random_.uniform(-30.0, 30.0);
    } else if (kind_ == DomainKind::triclinic || kind_ == DomainKind::long_triclinic) {
      for (std::size_t k = 0; k < axes_; ++k) {
        for (std::size_t axis = 0; axis < axes_; ++axis) {
          if (axis != k) vectors_[k][axis] = random_.uniform(-0.45, 0.45);
        }
      }
    }
    if (kind_ == DomainKind::long_cell || kind_ == DomainKind::long_triclinic) {
      // Elements of a cell that leans over lie many short vectors away from its corner.
      const int exponent = kind_ == DomainKind::long_cell ? exponent_of({10, 30, 40, 50, 60, 100})
                                                          : exponent_of({5, 10, 20, 28});
      if (kind_ == DomainKind::long_cell) vectors_ = diagonal();
      for (double& x : vectors_[first]) x = std::ldexp(x, exponent);
      for (std::size_t k = 0; k < axes_; ++k) {
        // Now and then the short directions are open.
        if (k != first && random_.below(4) == 0) periodic_[k] = false;
      }
    }
  }

  [[nodiscard]] std::array<Vector, 3> diagonal() const {
    std::array<Vector, 3> result{};
    for (std::size_t k = 0; k < axes_; ++k) result[k][k] = vectors_[k][k];
    return result;
  }

  void choose_radii() {
    const double spacing =
        std::pow(1.0 / static_cast<double>(std::max<std::size_t>(count_, 2)), 1.0 / double(axes_));
    double largest = spacing * (random_.below(2) > 0 ? 0.25 : 0.375);
    if (count_ <= 2) largest = random_.below(2) > 0 ? 0.5 : 0.125;
    if (kind_ == DomainKind::small_cell) largest = std::min(largest, 0.25);
    const int least = extreme_ == Extreme::ratio ? exponent_of({-3, -10, -60}) : 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const double power = random_.uniform() * random_.uniform();
      scene_radius_.push_back(k == 0 ? largest : largest * std::exp2(std::floor(power * least)));
    }
    if (random_.below(3) == 0) margin_ = std::ldexp(largest, -3);
    if (random_.below(8) == 0) {
      margin_ = 2.0 * largest;
      for (double& radius : scene_radius_) radius = 0.0;
    }
  }

  /// In the first cell, where a long one is so in a part of it as wide as the others, or anywhere.
  Vector point() {
    Vector result{};
    const bool spread = random_.below(2) > 0;
    for (std::size_t k = 0; k < axes_; ++k) {
      double along = fraction();
      const double length = std::hypot(vectors_[k][0], vectors_[k][1], vectors_[k][2]);
      if (length > 100.0 && !spread) along = along / length + (random_.below(2) > 0 ? 0.5 : 0.0);
      if (length < 0.2) along /= length;
      for (std::size_t axis = 0; axis < axes_; ++axis) result[axis] += along * vectors_[k][axis];
    }
    return result;
  }

  void flatten() {
    const std::size_t axis = random_.below(axes_);
    const double middle = random_.below(2) > 0 ? 0.0 : random_.uniform();
    const double width = random_.below(2) > 0 ? 0.0 : 0x1p-60;
    for (Vector& point : points_)
      point[axis] = middle + width * static_cast<double>(random_.below(5));
    if (random_.below(2) == 0) return;
    for (Vector& point : points_) point[(axis + 1) % axes_] = middle;
  }

  void move_by_cells() {
    const double most = std::exp2(exponent_of({0, 3, 12, 29}));
    // What is many vectors of a sheared cell may be more of a short basis.
    double cells = kind_ == DomainKind::lees_edwards ? std::min(most, 0x1p20) : most;
    if (kind_ == DomainKind::long_triclinic) cells = std::min(cells, 2.0);
    for (Vector& point : points_) {
      for (std::size_t k = 0; k < axes_; ++k) {
        if (!periodic_[k] || random_.below(3) == 0) continue;
        const double times = std::nearbyint(random_.uniform(-cells, cells));
        for (std::size_t axis = 0; axis < axes_; ++axis) point[axis] += times * vectors_[k][axis];
      }
    }
  }

  /// On an axis that is open, or perpendicular to the only vector; where there is none, nobody.
  void send_astray() {
    std::vector<std::size_t> open;
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      bool leads = false;
      for (std::size_t k = 0; k < axes_; ++k)
        leads = leads || (periodic_[k] && vectors_[k][axis] != 0.0);
      if (!leads) open.push_back(axis);
    }
    if (open.empty() || points_.empty()) return;
    const double out = std::exp2(exponent_of({20, 60, 89, 91, 94, 120, 300, 700, 1000, 1019}));
    const std::size_t strays = 1 + random_.below(2);
    for (std::size_t k = 0; k < strays; ++k) {
      Vector& point = points_[random_.below(points_.size())];
      point[open[random_.below(open.size())]] = (random_.below(2) > 0 ? out : -out);
    }
  }

  /// Such that no vector is lost and nothing overflows.
  int choose_scale() {
    double largest = margin_;
    double shortest = 1.0;
    const auto include = [&](double x) {
      largest = std::max(largest, std::fabs(x));
      if (x != 0.0) shortest = std::min(shortest, std::fabs(x));
    };
    for (const Vector& vector : vectors_) std::for_each(vector.begin(), vector.end(), include);
    const int least = -1068 - std::ilogb(shortest);
    for (const Vector& point : points_) {
      for (const double x : point) largest = std::max(largest, std::fabs(x));
    }
    const int most = 1020 - (largest > 1.0 ? std::ilogb(largest) : 0);
    const int exponent =
        exponent_of({-1074, -1060, -1040, -1022, -990, -960, -940, -931, -925, -900, -870,
                     -500,  -100,  100,   500,   832,  895,  955,  961,  990,  1019});
    return std::clamp(exponent, std::min(least, most), most);
  }

  [[nodiscard]] ExtremeSystem scaled(int exponent) const {
    ExtremeSystem result;
    result.scene.dimensions = static_cast<int>(axes_);
    std::vector<double>* const columns[] = {&result.scene.x, &result.scene.y, &result.scene.z};
    for (std::size_t k = 0; k < count_; ++k) {
      for (std::size_t axis = 0; axis < axes_; ++axis) {
        columns[axis]->push_back(std::ldexp(points_[k][axis], exponent));
      }
      result.scene.radius.push_back(std::ldexp(scene_radius_[k], exponent));
    }
    result.margin = std::ldexp(margin_, exponent);
    std::array<Vector, 3> vectors = vectors_;
    for (auto& vector : vectors) {
      for (double& x : vector) x = std::ldexp(x, exponent);
    }
    unsigned along = 0;
    for (std::size_t k = 0; k < axes_; ++k) along |= periodic_[k] ? 1u << k : 0u;
    if (along == 0) return result;
    const auto axes = static_cast<Axes>(along);
    if (axes_ == 3) {
      result.domain = Domain::lattice(vectors[0], vectors[1], vectors[2], axes);
    } else {
      result.domain =
          Domain::lattice({vectors[0][0], vectors[0][1]}, {vectors[1][0], vectors[1][1]}, axes);
    }
    return result;
  }

  DomainKind kind_;
  Extreme extreme_;
  std::size_t axes_;
  std::size_t count_;
  Random random_;
  std::array<Vector, 3> vectors_{};
  std::array<bool, 3> periodic_{};
  std::vector<Vector> points_;
  std::vector<double> scene_radius_;
  double margin_ = 0.0;
};

}  // namespace

std::string_view name_of(DomainKind kind) {
  static constexpr std::array names{"open",      "one axis",           "two axes",     "all axes",
                                    "triclinic", "one oblique vector", "Lees-Edwards", "small cell",
                                    "long cell", "long triclinic cell"};
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name_of(Extreme extreme) {
  static constexpr std::array names{"none", "stray", "far cells",      "scale",
                                    "flat", "ratio", "stray and scale"};
  return names[static_cast<std::size_t>(extreme)];
}

ExtremeSystem extreme_system(DomainKind kind, Extreme extreme, int dimensions, std::size_t count,
                             std::uint64_t seed) {
  return Maker(kind, extreme, dimensions, count, seed).make();
}

}  // namespace abut::testing
