#pragma once

#include "exact/sphere.hpp"
#include "scenes/random.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <random>

/// Pairs of spheres that are hard to decide.
namespace abut::testing {

using scenes::Random;

template <int Dim>
struct HardPair {
  exact::Sphere<Dim> a;
  exact::Sphere<Dim> b;
  double margin;

  friend std::ostream& operator<<(std::ostream& out, const HardPair& pair) {
    out << std::hexfloat;
    for (const auto& sphere : {pair.a, pair.b}) {
      for (const double x : sphere.center) out << x << ' ';
      out << "r " << sphere.radius << ", ";
    }
    return out << "margin " << pair.margin << std::defaultfloat;
  }
};

/// A number in [-1, 1] with so many significant bits at most.
[[nodiscard]] inline double short_number(Random& random, int bits) {
  return std::ldexp(std::round(random.uniform(-1.0, 1.0) * std::ldexp(1.0, bits)), -bits);
}

[[nodiscard]] inline double moved_by_ulps(double value, int ulps) {
  for (; ulps > 0; --ulps) value = std::nextafter(value, HUGE_VAL);
  for (; ulps < 0; ++ulps) value = std::nextafter(value, -HUGE_VAL);
  return value;
}

template <int Dim>
void scale(HardPair<Dim>& pair, int exponent) {
  for (exact::Sphere<Dim>* sphere : {&pair.a, &pair.b}) {
    for (double& x : sphere->center) x = std::ldexp(x, exponent);
    sphere->radius = std::ldexp(sphere->radius, exponent);
  }
  pair.margin = std::ldexp(pair.margin, exponent);
}

/// Nowhere near the reach, as a rule.
template <int Dim>
[[nodiscard]] HardPair<Dim> ordinary_pair(Random& random) {
  HardPair<Dim> pair{};
  for (exact::Sphere<Dim>* sphere : {&pair.a, &pair.b}) {
    for (double& x : sphere->center) x = random.uniform(-1.0, 1.0);
    sphere->radius = random.uniform(0.0, 1.0);
  }
  pair.margin = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.5);
  return pair;
}

/// Sets radii and margin so that their sum is close to `reach`.
template <int Dim>
void share_out(HardPair<Dim>& pair, double reach, Random& random) {
  pair.margin = random.below(2) == 0 ? 0.0 : reach * random.uniform(0.0, 0.3);
  const double rest = reach - pair.margin;
  pair.a.radius = random.below(8) == 0 ? 0.0 : rest * random.uniform(0.0, 1.0);
  pair.b.radius = std::fmax(0.0, rest - pair.a.radius);
}

/// The reach is planted at the distance, give or take a few units in the last place.
template <int Dim>
[[nodiscard]] HardPair<Dim> borderline_pair(Random& random, int most_ulps) {
  HardPair<Dim> pair{};
  const int bits = 4 + static_cast<int>(random.below(50));
  long double distance_squared = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    pair.a.center[axis] = short_number(random, bits);
    pair.b.center[axis] = short_number(random, bits);
    const long double difference =
        static_cast<long double>(pair.a.center[axis]) - pair.b.center[axis];
    distance_squared += difference * difference;
  }
  const auto distance = static_cast<double>(std::sqrt(distance_squared));
  std::uniform_int_distribution<int> ulps(-most_ulps, most_ulps);
  share_out(pair, std::fmax(0.0, moved_by_ulps(distance, ulps(random))), random);
  pair.b.radius = std::fmax(0.0, pair.b.radius);
  return pair;
}

/// Distance and reach exactly equal: Pythagorean triples and quadruples of integers.
template <int Dim>
[[nodiscard]] HardPair<Dim> exact_tie(Random& random, int scale_bits) {
  static constexpr std::array<std::array<int, 4>, 5> quadruples{
      {{3, 4, 12, 13}, {2, 3, 6, 7}, {1, 4, 8, 9}, {6, 10, 15, 19}, {0, 0, 1, 1}}};
  static constexpr std::array<std::array<int, 3>, 4> triples{
      {{3, 4, 5}, {5, 12, 13}, {20, 21, 29}, {0, 1, 1}}};
  HardPair<Dim> pair{};
  const auto factor =
      static_cast<double>(1 + random.next() % ((std::uint64_t{1} << scale_bits) - 1));
  double reach = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    // A small integer beside a multiple of an integer: the difference is exact.
    pair.b.center[axis] = static_cast<double>(random.below(1000)) - 500.0;
  }
  if constexpr (Dim == 3) {
    const auto& q = quadruples[random.next() % quadruples.size()];
    for (std::size_t axis = 0; axis < 3; ++axis) pair.a.center[axis] = q[axis] * factor;
    reach = q[3] * factor;
  } else {
    const auto& t = triples[random.next() % triples.size()];
    for (std::size_t axis = 0; axis < 2; ++axis) pair.a.center[axis] = t[axis] * factor;
    reach = t[2] * factor;
  }
  for (int axis = 0; axis < Dim; ++axis) pair.a.center[axis] += pair.b.center[axis];
  pair.a.radius = std::floor(reach * random.uniform(0.0, 1.0));
  pair.b.radius = reach - pair.a.radius;
  scale(pair, static_cast<int>(random.below(41)) - 20);
  return pair;
}

/// Every number from the edges of the format.
[[nodiscard]] inline double extreme_number(Random& random) {
  using Limits = std::numeric_limits<double>;
  const double edges[] = {0.0,           -0.0,          Limits::denorm_min(),
                          Limits::min(), Limits::max(), 0x1p-480,
                          0x1p-481,      0x1p-537,      0x1p-538,
                          0x1p511,       0x1p512,       0x1.8p511,
                          1e-300,        1e300,         1.0,
                          0x1p1023,      0x1p-1022,     0x1p-960,
                          0x1p500,       0x1p-500};
  const auto sign = random.below(2) == 0 ? 1.0 : -1.0;
  switch (random.below(4)) {
    case 0:
      return sign * edges[random.next() % std::size(edges)];
    case 1:
      return sign * moved_by_ulps(edges[random.next() % std::size(edges)] / 2, 1);
    case 2:
      return sign * std::ldexp(static_cast<double>(random.below(1000)), -1074);
    default:
      return sign *
             std::ldexp(random.uniform(0.5, 1.0), static_cast<int>(random.below(2098)) - 1074);
  }
}

template <int Dim>
[[nodiscard]] HardPair<Dim> extreme_pair(Random& random) {
  HardPair<Dim> pair{};
  for (exact::Sphere<Dim>* sphere : {&pair.a, &pair.b}) {
    for (double& x : sphere->center) x = extreme_number(random);
    sphere->radius = std::fabs(extreme_number(random));
  }
  pair.margin = random.below(2) == 0 ? 0.0 : std::fabs(extreme_number(random));
  return pair;
}

}  // namespace abut::testing
