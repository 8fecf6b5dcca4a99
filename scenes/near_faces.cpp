// Pairs that straddle a whole cell: one element a hair before a face, its partner at about the
// reach behind it, a hair before or on the next face. A grid whose cells are exactly as wide as the
// reach sees some of them two cells apart, because (x - x_min) / d is rounded. Random scenes never
// contain such pairs.

#include "scenes/arithmetic.hpp"
#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace abut::scenes {
namespace {

template <class Real>
struct Straddle {
  Real before;
  Real behind;
};

/// One axis of the grid that these scenes are aimed at.
template <class Real>
struct PlainGrid {
  Real lower;
  Real reach;

  [[nodiscard]] int cell_by_division(Real x) const { return static_cast<int>((x - lower) / reach); }
  [[nodiscard]] int cell_by_reciprocal(Real x) const {
    return static_cast<int>((x - lower) * (Real{1} / reach));
  }
  [[nodiscard]] bool misses(const Straddle<Real>& pair, bool by_division) const {
    return by_division ? cell_by_division(pair.behind) - cell_by_division(pair.before) > 1
                       : cell_by_reciprocal(pair.behind) - cell_by_reciprocal(pair.before) > 1;
  }

  /// behind - before <= reach without rounding: the error of a difference is itself computed
  /// without error (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
  [[nodiscard]] bool touches(const Straddle<Real>& pair) const {
    const Real distance = pair.behind - pair.before;
    const Real part = distance - pair.behind;
    const Real error = (pair.behind - (distance - part)) - (pair.before + part);
    return distance < reach || (distance == reach && error <= Real{0});
  }
};

/// The pair about a face: `before` so many representable numbers above it, `behind` so many above
/// one reach further on.
template <class Real>
Straddle<Real> straddle(const PlainGrid<Real>& grid, int face, int before, int behind) {
  const Real first = neighbor_number(grid.lower + static_cast<Real>(face) * grid.reach, before);
  return {first, neighbor_number(first + grid.reach, behind)};
}

template <class Real>
Straddle<Real> any_straddle(const PlainGrid<Real>& grid, int cells, Random& random) {
  const int face = 1 + static_cast<int>(random.below(static_cast<std::size_t>(cells)));
  const int before = static_cast<int>(random.below(7)) - 5;
  const int behind = static_cast<int>(random.below(9)) - 4;
  return straddle(grid, face, before, behind);
}

/// All pairs that touch and that a plain grid misses.
template <class Real>
std::vector<Straddle<Real>> missed_pairs(const PlainGrid<Real>& grid, int cells, bool by_division) {
  std::vector<Straddle<Real>> missed;
  for (int face = 1; face <= cells; ++face) {
    for (int before = -5; before <= 1; ++before) {
      for (int behind = -4; behind <= 4; ++behind) {
        const Straddle<Real> pair = straddle(grid, face, before, behind);
        if (grid.touches(pair) && grid.misses(pair, by_division)) missed.push_back(pair);
      }
    }
  }
  return missed;
}

/// A grid, and pairs about its faces of three kinds in turn: touching ones that it misses by
/// division, by reciprocals, and any, touching or not.
template <class Real>
class Target {
 public:
  Target(int cells, Random& random) : cells_(cells), random_(random) {
    while (kinds_[0].empty() || kinds_[1].empty()) {
      const auto radius = static_cast<Real>(random.uniform(0.01, 0.02));
      const auto corner = static_cast<Real>(random.uniform(0.1, 0.9));
      grid_ = {corner, Real{2} * radius};
      kinds_ = {missed_pairs(grid_, cells, true), missed_pairs(grid_, cells, false)};
    }
  }

  [[nodiscard]] const PlainGrid<Real>& grid() const { return grid_; }

  Straddle<Real> draw(std::size_t number) {
    if (number % 3 == 2) return any_straddle(grid_, cells_, random_);
    const auto& kind = kinds_[number % 3];
    return kind[random_.below(kind.size())];
  }

 private:
  int cells_;
  Random& random_;
  PlainGrid<Real> grid_{};
  std::array<std::vector<Straddle<Real>>, 2> kinds_;
};

/// Element 0 marks the lower corner; pairs follow, along x, y(, z) in turn.
template <class Real, std::size_t Dim>
Scene near_faces(std::size_t count, std::uint64_t seed) {
  constexpr int cells = Dim == 2 ? 900 : 60;
  Random random(seed);
  Target<Real> target(cells, random);
  const Real corner = target.grid().lower;
  const Real reach = target.grid().reach;

  Scene scene = empty_scene(static_cast<int>(Dim), count);
  const auto add = [&](const std::array<Real, Dim>& center) {
    if (scene.size() == count) return;
    add_disc(scene, center[0], center[1], reach * Real{0.5});
    if constexpr (Dim == 3) scene.z.push_back(center[2]);
  };
  std::array<Real, Dim> center{};
  center.fill(corner);
  add(center);
  for (std::size_t number = 0; scene.size() < count; ++number) {
    for (Real& x : center) {
      x = corner + static_cast<Real>(random.uniform()) * static_cast<Real>(cells) * reach;
    }
    const Straddle<Real> pair = target.draw(number / Dim);
    center[number % Dim] = pair.before;
    add(center);
    center[number % Dim] = pair.behind;
    add(center);
  }
  return scene;
}

}  // namespace

Scene make_near_faces_2d(std::size_t count, std::uint64_t seed) {
  return near_faces<double, 2>(count, seed);
}
Scene make_near_faces(std::size_t count, std::uint64_t seed) {
  return near_faces<double, 3>(count, seed);
}
Scene make_near_faces_float32_2d(std::size_t count, std::uint64_t seed) {
  return near_faces<float, 2>(count, seed);
}
Scene make_near_faces_float32(std::size_t count, std::uint64_t seed) {
  return near_faces<float, 3>(count, seed);
}

}  // namespace abut::scenes
