#include "engine/layers/size_levels.hpp"

#include <algorithm>
#include <bit>

namespace abut::engine {
namespace {

/// Elements that tell where the levels are.
constexpr std::size_t samples = 1024;

/// More than what rounds a reach and a position.
constexpr double roundings = 0x1p-18;

/// The centers that elements may have that meet some of a level, but for their own radii.
template <int Dim>
class LevelBox {
 public:
  LevelBox() = default;
  /// Boxes reach twice as far from their lower corners as spheres of their radii do.
  LevelBox(const grid::Bounds<Dim>& level, double margin, double radii)
      : box_(level), radii_(radii * (1.0 + roundings)) {
    const double reach = (radii * level.largest_radius + margin) * (1.0 + roundings);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      box_.lower[axis] -= reach;
      box_.upper[axis] += reach;
    }
  }

  void include(const LevelBox& other) {
    box_.include(other.box_);
    radii_ = other.radii_;
  }

  [[nodiscard]] bool meets(const exact::Sphere<Dim>& sphere) const noexcept {
    const double reach = radii_ * sphere.radius;
    bool meets = true;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double x = sphere.center[axis];
      meets = meets && x - reach <= box_.upper[axis] && x + reach >= box_.lower[axis];
    }
    return meets;
  }

 private:
  grid::Bounds<Dim> box_;
  double radii_ = 1.0;
};

/// The boxes of all levels, and of all that are smaller than each.
template <int Dim>
struct LevelBoxes {
  LevelBoxes(const std::array<grid::Bounds<Dim>, LevelOfRadius::levels>& bounds, double margin,
             double radii) {
    for (std::size_t level = bounds.size(); level-- > 0;) {
      of[level] = LevelBox<Dim>(bounds[level], margin, radii);
      smaller[level] = of[level];
      if (level + 1 < bounds.size()) smaller[level].include(smaller[level + 1]);
    }
  }

  /// Calls visit(level) for the levels from the first one on in which a sphere may meet some.
  template <class Visit>
  void for_each_met(std::size_t first, const exact::Sphere<Dim>& sphere, const Visit& visit) const {
    for (std::size_t level = first; level < of.size() && smaller[level].meets(sphere); ++level) {
      if (of[level].meets(sphere)) visit(level);
    }
  }

  std::array<LevelBox<Dim>, LevelOfRadius::levels> of;
  std::array<LevelBox<Dim>, LevelOfRadius::levels> smaller;
};

template <int Dim>
exact::Sphere<Dim> with_radius(const LayerSpheres<Dim>& all, std::size_t k) {
  exact::Sphere<Dim> sphere = all[k];
  sphere.radius = all.radius(k);
  return sphere;
}

/// Calls visit(number, sphere) for the elements [begin, end).
template <int Dim, class Visit>
void for_each_sphere(const LayerSpheres<Dim>& all, std::size_t begin, std::size_t end,
                     const Visit& visit) {
  for (const auto& some : all.given().some(begin, end)) {
    for (std::size_t k = some.begin; k < some.end; ++k) {
      const std::size_t number = some.number_of_first + k;
      exact::Sphere<Dim> sphere = kernels::sphere_at<Dim>(some.columns, k);
      if (!all.have_radii()) sphere.radius = all.radius(number);
      visit(static_cast<std::uint32_t>(number), sphere);
    }
  }
}

template <int Dim>
double radii_of_reach(const LayerSpheres<Dim>& all) {
  return all.stand_for_boxes() ? 2.0 : 1.0;
}

}  // namespace

template <int Dim>
auto SizeLevels<Dim>::estimate(const LayerSpheres<Dim>& all, const grid::Bounds<Dim>& bounds,
                               double margin) -> LevelsEstimate {
  const LevelOfRadius level_of(bounds.largest_radius, margin);
  const std::size_t count = std::min(samples, all.size());
  std::array<exact::Sphere<Dim>, samples> drawn;
  std::uint32_t have_some = 0;
  bounds_.fill({});
  for (std::size_t k = 0; k < count; ++k) {
    drawn[k] = with_radius(all, k * all.size() / count);
    const std::size_t level = level_of(drawn[k].radius);
    have_some |= std::uint32_t{1} << level;
    bounds_[level].include_center(drawn[k]);
    bounds_[level].include_radius(drawn[k].radius);
  }
  const LevelBoxes<Dim> boxes(bounds_, margin, radii_of_reach(all));
  std::size_t visitors = 0;
  for (std::size_t k = 0; k < count; ++k) {
    boxes.for_each_met(level_of(drawn[k].radius) + 1, drawn[k], [&](std::size_t) { ++visitors; });
  }
  return {static_cast<std::size_t>(std::popcount(have_some)),
          static_cast<double>(visitors) / static_cast<double>(count)};
}

template <int Dim>
void SizeLevels<Dim>::find_levels(const LayerSpheres<Dim>& all, const LevelOfRadius& level_of,
                                  base::WorkCounter& work) {
  base::make_room(levels_, all.size());
  bounds_.fill({});
  std::array<std::size_t, most> counts{};
  work.in_pieces(0, all.size(), [&](std::size_t begin, std::size_t end) {
    for_each_sphere(all, begin, end, [&](std::uint32_t k, const exact::Sphere<Dim>& sphere) {
      const std::size_t level = level_of(sphere.radius);
      levels_[k] = static_cast<std::uint8_t>(level);
      ++counts[level];
      bounds_[level].include_center(sphere);
      bounds_[level].include_radius(sphere.radius);
    });
  });
  for (std::size_t level = 0; level < most; ++level) {
    begin_[level + 1] = begin_[level] + counts[level];
    if (all.stand_for_boxes()) bounds_[level].count_largest_twice();
  }
}

template <int Dim>
void SizeLevels<Dim>::sort(const LayerSpheres<Dim>& all, const grid::Bounds<Dim>& bounds,
                           double margin, double slack, base::WorkCounter& work) {
  find_levels(all, LevelOfRadius(bounds.largest_radius, margin), work);
  const LevelBoxes<Dim> boxes(bounds_, margin + slack, radii_of_reach(all));
  base::make_room(members_, all.size());
  for (auto& visitors : visitors_) visitors.clear();
  largest_visitor_.fill(0.0);
  std::array<std::size_t, most + 1> next = begin_;
  work.in_pieces(0, all.size(), [&](std::size_t begin, std::size_t end) {
    for_each_sphere(all, begin, end, [&](std::uint32_t k, const exact::Sphere<Dim>& sphere) {
      const std::size_t level = levels_[k];
      members_[next[level]++] = k;
      boxes.for_each_met(level + 1, sphere, [&](std::size_t smaller) {
        visitors_[smaller].push_back(k);
        largest_visitor_[smaller] = std::max(largest_visitor_[smaller], sphere.radius);
      });
    });
  });
}

template class SizeLevels<2>;
template class SizeLevels<3>;

}  // namespace abut::engine
