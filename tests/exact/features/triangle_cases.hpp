#pragma once

#include "exact/features/triangle_oracle.hpp"
#include "exact/hard_pairs.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <ostream>

/// Spheres against triangles, in open space or with a lattice between them, and what was decided.
namespace abut::testing {

struct TriangleCase {
  exact::Sphere<3> sphere;
  exact::Triangle triangle;
  double margin = 0.0;

  friend std::ostream& operator<<(std::ostream& out, const TriangleCase& c) {
    out << std::hexfloat << "center";
    for (const double x : c.sphere.center) out << ' ' << x;
    out << " radius " << c.sphere.radius << " margin " << c.margin;
    for (const auto& corner : c.triangle.corner) {
      out << ", corner";
      for (const double x : corner) out << ' ' << x;
    }
    return out << std::defaultfloat;
  }
};

/// A radius and a margin that reach from the center to the nearest point, give or take some last
/// places.
inline void plant_reach(TriangleCase& c, const RationalPoint& center, Random& random) {
  mpf_class distance(nearest_part_by_rationals(center, c.triangle).distance_squared, 300);
  distance = sqrt(distance);
  const int ulps = static_cast<int>(random.below(7)) - 3;
  const double reach = std::fmax(0.0, moved_by_ulps(distance.get_d(), ulps));
  c.margin = random.below(2) == 0 ? 0.0 : reach * random.uniform(0.0, 0.5);
  c.sphere.radius = reach - c.margin;
}

inline void scale(TriangleCase& c, int exponent) {
  for (double& x : c.sphere.center) x = std::ldexp(x, exponent);
  for (auto& corner : c.triangle.corner) {
    for (double& x : corner) x = std::ldexp(x, exponent);
  }
  c.sphere.radius = std::ldexp(c.sphere.radius, exponent);
  c.margin = std::ldexp(c.margin, exponent);
}

/// What was decided how often.
struct PartCount {
  std::uint64_t cases = 0;
  std::uint64_t within = 0;
  std::uint64_t exact_decisions = 0;
  std::map<exact::TrianglePart, std::uint64_t> parts;

  void note(const std::optional<exact::TrianglePart>& part) {
    ++cases;
    if (!part) return;
    ++within;
    ++parts[*part];
  }
};

inline void expect_all_parts(const PartCount& count, std::uint64_t each) {
  for (int part = 0; part < 7; ++part) {
    const auto found = count.parts.find(static_cast<exact::TrianglePart>(part));
    EXPECT_GE(found == count.parts.end() ? 0 : found->second, each) << "part " << part;
  }
}

}  // namespace abut::testing
