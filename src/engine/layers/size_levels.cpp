#include "engine/layers/size_levels.hpp"

#include "base/asking_workers.hpp"

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
    std::uint32_t apart = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double x = sphere.center[axis];
      apart |= static_cast<std::uint32_t>(x - reach > box_.upper[axis]);
      apart |= static_cast<std::uint32_t>(x + reach < box_.lower[axis]);
    }
    return apart == 0;
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
SizeLevels<Dim>::LevelsShare::LevelsShare(base::MemoryMeter& memory) {
  for (std::size_t level = 0; level < most; ++level) {
    visitors.push_back(base::make_array_for_overwrite<std::uint32_t>(memory, 0));
  }
}

template <int Dim>
void SizeLevels<Dim>::start(std::size_t elements, std::size_t workers) {
  base::make_room(levels_, elements);
  base::make_room(members_, elements);
  while (shares_.size() < workers) shares_.emplace_back(memory_);
  for (LevelsShare& share : shares_) {
    share.count.fill(0);
    share.bounds.fill({});
    for (auto& visitors : share.visitors) visitors.clear();
    share.largest_visitor.fill(0.0);
  }
}

/// Calls visit(share, number, sphere) for all elements, in the order of their numbers in each
/// share.
template <int Dim>
template <class Visit>
void SizeLevels<Dim>::for_each_sphere_of_share(const LayerSpheres<Dim>& all, std::size_t workers,
                                               base::WorkCounter& work, const Visit& visit) {
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    LevelsShare& share = shares_[worker];
    const auto [first, last] = base::share_of(worker, workers, all.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for_each_sphere(all, begin, end, [&](std::uint32_t k, const exact::Sphere<Dim>& sphere) {
        visit(share, k, sphere);
      });
    });
  });
}

/// Makes places of the members of what was counted, in each level share by share.
template <int Dim>
void SizeLevels<Dim>::lay_out(const LayerSpheres<Dim>& all, std::size_t workers) {
  bounds_.fill({});
  for (std::size_t level = 0; level < most; ++level) {
    std::size_t next = begin_[level];
    for (LevelsShare& share : std::span(shares_).first(workers)) {
      share.next[level] = next;
      next += share.count[level];
      bounds_[level].include(share.bounds[level]);
    }
    begin_[level + 1] = next;
    if (all.stand_for_boxes()) bounds_[level].count_largest_twice();
  }
}

/// Adds what the others found to what the first one did.
template <int Dim>
void SizeLevels<Dim>::join_visitors(std::size_t workers) {
  largest_visitor_ = shares_[0].largest_visitor;
  for (const LevelsShare& share : std::span(shares_).first(workers).subspan(1)) {
    for (std::size_t level = 0; level < most; ++level) {
      auto& all = shares_[0].visitors[level];
      all.insert(all.end(), share.visitors[level].begin(), share.visitors[level].end());
      largest_visitor_[level] = std::max(largest_visitor_[level], share.largest_visitor[level]);
    }
  }
}

template <int Dim>
void SizeLevels<Dim>::sort(const LayerSpheres<Dim>& all, const grid::Bounds<Dim>& bounds,
                           double margin, double slack, std::size_t workers,
                           base::WorkCounter& work) {
  start(all.size(), workers);
  const LevelOfRadius level_of(bounds.largest_radius, margin);
  using Sphere = exact::Sphere<Dim>;
  for_each_sphere_of_share(all, workers, work,
                           [&](LevelsShare& share, std::uint32_t k, const Sphere& sphere) {
                             const std::size_t level = level_of(sphere.radius);
                             levels_[k] = static_cast<std::uint8_t>(level);
                             ++share.count[level];
                             share.bounds[level].include_center(sphere);
                             share.bounds[level].include_radius(sphere.radius);
                           });
  lay_out(all, workers);
  const LevelBoxes<Dim> boxes(bounds_, margin + slack, radii_of_reach(all));
  for_each_sphere_of_share(all, workers, work,
                           [&](LevelsShare& share, std::uint32_t k, const Sphere& sphere) {
                             const std::size_t level = levels_[k];
                             members_[share.next[level]++] = k;
                             boxes.for_each_met(level + 1, sphere, [&](std::size_t smaller) {
                               share.visitors[smaller].push_back(k);
                               double& largest = share.largest_visitor[smaller];
                               largest = std::max(largest, sphere.radius);
                             });
                           });
  join_visitors(workers);
}

template class SizeLevels<2>;
template class SizeLevels<3>;

}  // namespace abut::engine
