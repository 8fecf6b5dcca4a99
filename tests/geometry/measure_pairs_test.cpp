// Vectors of pairs have the bits of the scalar code at every SIMD level, wherever numbers lie.

#include "geometry/measure_pairs.hpp"
#include "exact/center_line.hpp"
#include "exact/distance_vector.hpp"
#include "exact/periodic_gap.hpp"
#include "kernels/measure_kernels.hpp"
#include "scenes/random.hpp"

#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

template <int Dim>
struct Pairs {
  std::vector<exact::Sphere<Dim>> spheres;
  std::vector<ContactPair> pairs;
  std::vector<ImageShift> shifts;
  exact::Lattice lattice;
};

/// A number of a scale: smooth, on a grid, 0, or of a float.
double some_number(Random& random, double scale) {
  const double fine = random.uniform(-1.0, 1.0);
  switch (random.below(6)) {
    case 0:
      return scale * (std::round(fine * 4.0) / 4.0);
    case 1:
      return 0.0;
    case 2:
      return scale * static_cast<double>(static_cast<float>(fine));
    default:
      return scale * fine;
  }
}

template <int Dim>
Pairs<Dim> some_pairs(Random& random, double scale, double radius, bool with_shifts) {
  Pairs<Dim> result;
  for (int k = 0; k < 40; ++k) {
    exact::Sphere<Dim> sphere{};
    for (double& x : sphere.center) x = some_number(random, scale);
    sphere.radius = std::fabs(some_number(random, radius));
    result.spheres.push_back(sphere);
  }
  for (std::size_t k = 0; k < Dim; ++k) {
    result.lattice.periodic[k] = k != 1 || random.below(2) == 0;
    for (double& x : result.lattice.vectors[k]) x = some_number(random, scale);
  }
  for (int k = 0; k < 1500; ++k) {
    result.pairs.push_back(
        {static_cast<ElementIndex>(random.below(40)), static_cast<ElementIndex>(random.below(40))});
    if (!with_shifts) continue;
    const auto cells = [&] {
      return random.below(2) == 0 ? 0 : static_cast<std::int32_t>(random.below(7)) - 3;
    };
    result.shifts.push_back(
        {cells(), result.lattice.periodic[1] ? cells() : 0, Dim == 3 ? cells() : 0});
  }
  return result;
}

bool alike(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool alike(const Vector& a, const Vector& b) {
  return alike(a[0], b[0]) && alike(a[1], b[1]) && alike(a[2], b[2]);
}

template <int Dim>
void check_pair(const Pairs<Dim>& given, std::size_t k, const PairGeometry& found) {
  const auto& a = given.spheres[given.pairs[k].first];
  const auto& b = given.spheres[given.pairs[k].second];
  const ImageShift shift = given.shifts.empty() ? ImageShift{} : given.shifts[k];
  ASSERT_TRUE(alike(found.gaps[k], exact::gap(a, b, shift, given.lattice))) << k;
  const auto expected = exact::distance_vector(a, b, shift, given.lattice);
  ASSERT_TRUE(alike(found.distances[k], expected.distance)) << k;
  ASSERT_TRUE(alike(found.vectors[k], expected.vector)) << k;
  const exact::CenterLine<Dim> line(a, b, shift, given.lattice);
  ASSERT_TRUE(alike(found.normals[k], line.normal())) << k;
  ASSERT_TRUE(alike(found.points[k], line.point())) << k;
}

template <int Dim>
void measure_into(PairGeometry& geometry, const Pairs<Dim>& given, Simd level) {
  const exact::Elements<Dim> elements{given.spheres, {}};
  geometry::measure_some<Dim>({elements, elements, given.lattice, kernels::measure_kernels(level)},
                              given.pairs, given.shifts, geometry.spans());
}

template <int Dim>
PairGeometry measured(const Pairs<Dim>& given, Simd level) {
  PairGeometry geometry;
  const std::size_t count = given.pairs.size();
  geometry.gaps.resize(count);
  geometry.distances.resize(count);
  geometry.normals.resize(count);
  geometry.points.resize(count);
  geometry.vectors.resize(count);
  measure_into(geometry, given, level);
  return geometry;
}

/// Vectors that are wanted alone, which takes fewer operations.
template <int Dim>
PairGeometry vectors_alone(const Pairs<Dim>& given, Simd level) {
  PairGeometry geometry;
  geometry.vectors.resize(given.pairs.size());
  measure_into(geometry, given, level);
  return geometry;
}

template <int Dim>
void check(const Pairs<Dim>& given) {
  for (const Simd level : simd_levels()) {
    if (!available(level)) continue;
    SCOPED_TRACE(name_of(level));
    const PairGeometry found = measured(given, level);
    const PairGeometry alone = vectors_alone(given, level);
    for (std::size_t k = 0; k < given.pairs.size(); ++k) {
      check_pair(given, k, found);
      ASSERT_TRUE(alike(alone.vectors[k], found.vectors[k])) << k;
    }
  }
}

TEST(MeasurePairs, HaveTheBitsOfScalarCodeAtEveryScale) {
  Random random(1510);
  for (const double scale :
       {1.0, 1e-9, 0x1p479, 0x1p481, 0x1p-399, 0x1p-402, 0x1p900, 0x1p1023, 0x1p-1040}) {
    for (const double relative : {1.0, 0x1p-40, 0x1p30}) {
      const double radius = std::min(scale * relative, 0x1p1023);
      for (const bool with_shifts : {false, true}) {
        check(some_pairs<2>(random, scale, radius, with_shifts));
        check(some_pairs<3>(random, scale, radius, with_shifts));
      }
    }
  }
}

/// The middle of the centers is 0, so that the point is what half the difference of the radii
/// gives: a product that underflows, whose error is no double.
TEST(MeasurePairs, HaveTheBitsOfScalarCodeWhereRadiiUnderflow) {
  Random random(1512);
  Pairs<3> given;
  for (int k = 0; k < 3000; ++k) {
    exact::Sphere<3> sphere{};
    for (double& x : sphere.center) x = random.uniform(-1.0, 1.0);
    sphere.radius =
        random.uniform(0.0, 0x1p-1015) * std::ldexp(1.0, -static_cast<int>(random.below(60)));
    given.spheres.push_back(sphere);
    for (double& x : sphere.center) x = -x;
    sphere.radius = 0.0;
    given.spheres.push_back(sphere);
    const auto first = static_cast<ElementIndex>(2 * k);
    given.pairs.push_back({first, first + 1});
  }
  check(given);
}

/// Distances that doubles represent, and gaps of exactly 0.
TEST(MeasurePairs, HaveTheBitsOfScalarCodeOnTouchingLattices) {
  Pairs<3> given;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) {
        given.spheres.push_back({{x * 1.0, y * 1.0, z * 1.0}, 0.5});
      }
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    given.lattice.vectors[axis][axis] = 4.0;
    given.lattice.periodic[axis] = true;
  }
  Random random(1511);
  for (int k = 0; k < 3000; ++k) {
    given.pairs.push_back(
        {static_cast<ElementIndex>(random.below(64)), static_cast<ElementIndex>(random.below(64))});
    given.shifts.push_back({static_cast<std::int32_t>(random.below(3)) - 1, 0, 1});
  }
  check(given);
}

/// Spheres in a box of which no number has more bits than a double between 16 and 32: differences
/// across a face are of such bits, too, and often the middle of two doubles.
Pairs<3> pairs_across_faces(Random& random) {
  Pairs<3> given;
  const auto cut = [](double x) { return std::round(x * 0x1p48) * 0x1p-48; };
  const double side = cut(random.uniform(16.0, 32.0));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    given.lattice.vectors[axis][axis] = side;
    given.lattice.periodic[axis] = true;
  }
  const auto near_face = [&](double offset) {
    return exact::Sphere<3>{{offset + random.uniform(0.0, 1.0), random.uniform(0.0, 1.0),
                             offset + random.uniform(0.0, 1.0)},
                            0.5};
  };
  for (ElementIndex k = 0; k < 1024; ++k) {
    given.spheres.push_back(near_face(0.0));
    given.spheres.push_back(near_face(cut(side - 1.0)));
    given.pairs.push_back({2 * k, 2 * k + 1});
    given.shifts.push_back({-1, 0, -1});
  }
  return given;
}

TEST(MeasurePairs, HaveTheBitsOfScalarCodeInTheMiddleOfTwoDoubles) {
  Random random(1513);
  check(pairs_across_faces(random));
  // Another lattice vector moves the middle by next to nothing, or by less than doubles tell.
  for (const double least :
       {0x1p-100, 0x1p-390, 0x1.23456789abcdfp-500, 0x1.23456789abcdfp-1020, 0x1p-1074}) {
    Pairs<3> given = pairs_across_faces(random);
    given.lattice.vectors[1] = {least, 7.0, -3.0 * least};
    for (ImageShift& shift : given.shifts) shift.y = static_cast<std::int32_t>(random.below(7)) - 3;
    check(given);
  }
}

/// A middle that is known as such needs no second look: nearly a third of these pairs have one.
TEST(MeasurePairs, FewAreLookedAtTwiceAcrossFaces) {
  Random random(1514);
  const Pairs<3> given = pairs_across_faces(random);
  std::vector<Vector> vectors(given.pairs.size());
  for (const Simd level : simd_levels()) {
    if (!available(level) || level == Simd::scalar) continue;
    kernels::MeasureJob job{};
    job.pairs = given.pairs.data();
    job.shifts = given.shifts.data();
    job.count = given.pairs.size();
    job.first = job.second = given.spheres[0].center;
    double lattice[3][3];
    for (std::size_t k = 0; k < 3; ++k) std::ranges::copy(given.lattice.vectors[k], lattice[k]);
    job.lattice = lattice;
    job.vectors = reinterpret_cast<double(*)[3]>(vectors.data());
    std::array<std::uint32_t, kernels::most_measured> open;
    std::size_t open_count = 0;
    EXPECT_EQ(kernels::measure_kernels(level).measure(job, 3, open.data(), open_count),
              given.pairs.size());
    EXPECT_LE(open_count, 2u) << name_of(level);
  }
}

}  // namespace
}  // namespace abut::testing
