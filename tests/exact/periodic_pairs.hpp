#pragma once

#include "exact/hard_pairs.hpp"
#include "exact/lattice.hpp"
#include "exact/rational_oracle.hpp"

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <random>
#include <utility>

/// Pairs of spheres with a lattice between them that are hard to decide, and what rational numbers
/// say to them.
namespace abut::testing {

template <int Dim>
struct PeriodicPair {
  HardPair<Dim> spheres;
  exact::Lattice lattice;
  ImageShift shift;

  friend std::ostream& operator<<(std::ostream& out, const PeriodicPair& pair) {
    out << pair.spheres << std::hexfloat << ", lattice ";
    for (std::size_t k = 0; k < Dim; ++k) {
      for (std::size_t axis = 0; axis < Dim; ++axis) out << pair.lattice.vectors[k][axis] << ' ';
      out << (pair.lattice.periodic[k] ? "periodic, " : "open, ");
    }
    return out << std::defaultfloat << "shift " << pair.shift.x << ' ' << pair.shift.y << ' '
               << pair.shift.z;
  }
};

/// x_a - (x_b + n A) on one axis.
template <int Dim>
[[nodiscard]] mpq_class exact_component(const PeriodicPair<Dim>& pair, std::size_t axis) {
  mpq_class result =
      mpq_class(pair.spheres.a.center[axis]) - mpq_class(pair.spheres.b.center[axis]);
  for (std::size_t k = 0; k < Dim; ++k) {
    if (!pair.lattice.periodic[k]) continue;
    result -= exact::numbers(pair.shift)[k] * mpq_class(pair.lattice.vectors[k][axis]);
  }
  return result;
}

template <int Dim>
[[nodiscard]] mpq_class exact_distance_squared(const PeriodicPair<Dim>& pair) {
  mpq_class sum = 0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const mpq_class component = exact_component(pair, axis);
    sum += component * component;
  }
  return sum;
}

template <int Dim>
[[nodiscard]] bool within_reach_by_rationals(const PeriodicPair<Dim>& pair) {
  const mpq_class reach = exact_reach(pair.spheres.a, pair.spheres.b, pair.spheres.margin);
  return exact_distance_squared(pair) <= reach * reach;
}

/// a and b exchanged, seen from the other side.
template <int Dim>
[[nodiscard]] PeriodicPair<Dim> exchanged(PeriodicPair<Dim> pair) {
  std::swap(pair.spheres.a, pair.spheres.b);
  pair.shift = {-pair.shift.x, -pair.shift.y, -pair.shift.z};
  return pair;
}

/// From 1 to all of 31 bits, of either sign.
[[nodiscard]] inline std::int32_t random_number_of_cells(Random& random, int bits) {
  if (bits >= 31 && random.below(4) == 0) {
    return random.below(2) == 0 ? std::numeric_limits<std::int32_t>::max()
                                : -std::numeric_limits<std::int32_t>::max();
  }
  const auto limit = (std::int64_t{1} << bits) - 1;
  return static_cast<std::int32_t>(
      std::uniform_int_distribution<std::int64_t>(-limit, limit)(random));
}

template <int Dim>
void choose_periodic_axes(PeriodicPair<Dim>& pair, int bits_of_shift, Random& random) {
  const std::size_t always = random.below(Dim);
  for (std::size_t k = 0; k < Dim; ++k) {
    pair.lattice.periodic[k] = k == always || random.below(2) == 0;
  }
  pair.shift.x = random_number_of_cells(random, bits_of_shift);
  pair.shift.y = random_number_of_cells(random, bits_of_shift);
  if constexpr (Dim == 3) pair.shift.z = random_number_of_cells(random, bits_of_shift);
}

template <int Dim>
void set_lattice(PeriodicPair<Dim>& pair, double (*number)(Random&), Random& random) {
  for (std::size_t k = 0; k < Dim; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) pair.lattice.vectors[k][axis] = number(random);
  }
}

/// b near minus the shift, so that a and the image of b, near the origin, are what heavy
/// cancellation leaves; the reach is planted at their distance, give or take a few units.
template <int Dim>
[[nodiscard]] PeriodicPair<Dim> cancelling_pair(Random& random, int bits_of_shift) {
  PeriodicPair<Dim> pair{};
  choose_periodic_axes(pair, bits_of_shift, random);
  const bool coarse = random.below(3) == 0;
  set_lattice<Dim>(
      pair,
      coarse ? [](Random& r) { return short_number(r, 8); }
             : [](Random& r) { return r.uniform(-1.0, 1.0); },
      random);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    pair.spheres.a.center[axis] = coarse ? short_number(random, 12) : random.uniform(-1.0, 1.0);
    // What is left of a - n A: b added to it, and the difference is small.
    const double moved = exact_component(pair, axis).get_d();
    pair.spheres.b.center[axis] =
        moved + (coarse ? short_number(random, 8) : random.uniform(-1, 1));
  }
  mpf_class distance(0, 300);
  distance = exact_distance_squared(pair);
  distance = sqrt(distance);
  const double reach = moved_by_ulps(distance.get_d(), static_cast<int>(random.below(7)) - 3);
  share_out(pair.spheres, std::fmax(0.0, reach), random);
  return pair;
}

/// Distance and reach exactly equal: an exact tie in open space with b's center moved back by n
/// whole vectors of small integers.
template <int Dim>
[[nodiscard]] PeriodicPair<Dim> periodic_tie(Random& random, int bits_of_shift) {
  PeriodicPair<Dim> pair{};
  pair.spheres = exact_tie<Dim>(random, 1 + static_cast<int>(random.below(10)));
  choose_periodic_axes(pair, bits_of_shift, random);
  const double unit = std::ldexp(1.0, static_cast<int>(random.below(20)) - 10);
  for (std::size_t k = 0; k < Dim; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      pair.lattice.vectors[k][axis] = (static_cast<double>(random.below(100)) - 50.0) * unit;
      if (!pair.lattice.periodic[k]) continue;
      pair.spheres.b.center[axis] -= exact::numbers(pair.shift)[k] * pair.lattice.vectors[k][axis];
    }
  }
  return pair;
}

template <int Dim>
[[nodiscard]] PeriodicPair<Dim> extreme_periodic_pair(Random& random) {
  PeriodicPair<Dim> pair{};
  pair.spheres = extreme_pair<Dim>(random);
  choose_periodic_axes(pair, random.below(2) == 0 ? 31 : 2, random);
  set_lattice<Dim>(
      pair, [](Random& r) { return r() % 4 == 0 ? 0.0 : extreme_number(r); }, random);
  return pair;
}

template <int Dim>
void scale(PeriodicPair<Dim>& pair, int exponent) {
  scale(pair.spheres, exponent);
  for (auto& vector : pair.lattice.vectors) {
    for (double& x : vector) x = std::ldexp(x, exponent);
  }
}

}  // namespace abut::testing
