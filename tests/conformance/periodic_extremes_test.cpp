// Every kind of domain with every extreme of what numbers can say, by every face of the library,
// against direct_check; small systems against all images in rational numbers, too.
//
// Which test has which kind of domain x extreme ("S": these systems, of 0 to 200 elements; the
// others are in files of their own):
//
//                  none | stray | far cells | scale | flat | ratio | stray and scale
//   open           S, extremes_test, near_faces_test, rows_far_visitors_test (stray, ratio)
//   1, 2, 3 axes   S, periodic_rows_test, periodic_faces_test, images_test (far cells, scale)
//   triclinic      S, images_test (far cells, scale, ratio)
//   one oblique    S
//   Lees-Edwards   S, periodic_rows_test (none)
//   small cell     S, images_test (none), LongReach here
//   long cell      S, LongCell here
//   long triclinic S
//
// Strays need an axis that no vector leads along, and are none where there is no such axis.

#include "support/periodic_extremes.hpp"
#include "periodic/periodic_search.hpp"
#include "support/algorithm_list.hpp"
#include "support/box_oracle.hpp"
#include "support/error_expectations.hpp"
#include "support/periodic_oracle.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detector.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace abut::testing {
namespace {

using scenes::BoxScene;
using scenes::Scene;

std::vector<ImagePair> image_pairs(const PairList& list) {
  std::vector<ImagePair> pairs;
  for (std::size_t k = 0; k < list.size(); ++k) pairs.push_back({list[k], list.shifts()[k]});
  return pairs;
}

Options options_of(const ExtremeSystem& system, Algorithm algorithm) {
  return {.algorithm = algorithm, .shifts = Shifts::stored, .margin = system.margin, .threads = 1};
}

/// All images within reach in rational numbers, each pair once, in canonical order.
template <int Dim>
std::vector<ImagePair> pairs_in_rationals(const ExtremeSystem& system) {
  test::PeriodicSystem<Dim> exact;
  const std::vector<double>* const columns[] = {&system.scene.x, &system.scene.y, &system.scene.z};
  for (std::size_t k = 0; k < system.scene.size(); ++k) {
    base::Sphere<Dim> sphere{};
    for (std::size_t axis = 0; axis < Dim; ++axis) sphere.center[axis] = (*columns[axis])[k];
    sphere.radius = system.scene.radius[k];
    exact.spheres.push_back(sphere);
  }
  for (int axis = 0; axis < 3; ++axis) {
    exact.lattice.vectors[static_cast<std::size_t>(axis)] = system.domain.vector(axis);
    exact.lattice.periodic[static_cast<std::size_t>(axis)] = system.domain.is_periodic(axis);
  }
  exact.margin = system.margin;
  std::vector<ImagePair> pairs;
  for (const test::FoundPair& pair : test::pairs_by_rationals(exact)) {
    pairs.push_back(
        {{static_cast<ElementIndex>(pair.i), static_cast<ElementIndex>(pair.j)}, pair.shift});
  }
  return pairs;
}

/// The faces that tell one set's pairs, in turn.
class Faces {
 public:
  Faces(const ElementView& view, const Domain& domain, const Options& options,
        const std::vector<ImagePair>& expected)
      : view_(view), domain_(domain), options_(options), expected_(expected) {}

  void check_all() {
    check_lists();
    check_count_and_visitor();
    check_neighbors();
    check_detector();
  }

  /// Elements that move little, three times over, with a skin.
  static void check_skin(const ExtremeSystem& system) {
    ExtremeSystem moved = system;
    Detector detector(options_of(system, Algorithm::rows));
    const double largest = *std::max_element(moved.scene.radius.begin(), moved.scene.radius.end());
    detector.set_skin(Skin::fixed(0.25 * largest));
    for (int step = 0; step < 3; ++step) {
      const auto expected = image_pairs(find_contact_pairs(
          view_of(moved.scene), moved.domain, options_of(moved, Algorithm::direct_check)));
      const auto found =
          image_pairs(detector.find_contact_pairs(view_of(moved.scene), moved.domain));
      EXPECT_TRUE(found == expected) << "step " << step << " with a skin: " << found.size()
                                     << " pairs for " << expected.size();
      for (std::size_t k = 0; k < moved.scene.size(); k += 2) moved.scene.y[k] += 0.0625 * largest;
    }
  }

 private:
  void check_lists() {
    for (const Simd level : simd_levels_here()) {
      for (const int threads : {1, 3}) {
        Options options = options_;
        options.simd = level;
        options.threads = threads;
        const auto found = image_pairs(find_contact_pairs(view_, domain_, options));
        EXPECT_TRUE(found == expected_) << name_of(level) << ", threads " << threads << ": "
                                        << found.size() << " pairs for " << expected_.size();
      }
    }
  }

  void check_count_and_visitor() {
    EXPECT_EQ(count_contact_pairs(view_, domain_, options_).contact_pairs, expected_.size());
    std::vector<ImagePair> visited;
    for_each_shifted_pair(view_, domain_, options_, [&](ContactPair pair, ImageShift shift) {
      visited.push_back({pair, shift});
    });
    std::sort(visited.begin(), visited.end());
    EXPECT_TRUE(visited == expected_) << "visitor";
  }

  void check_neighbors() {
    std::vector<ImagePair> both = expected_;
    for (const auto& [pair, shift] : expected_) {
      both.push_back({{pair.second, pair.first}, {-shift.x, -shift.y, -shift.z}});
    }
    std::sort(both.begin(), both.end());
    for (const NeighborListKind kind : {NeighborListKind::half, NeighborListKind::full}) {
      const NeighborList list = build_neighbor_list(view_, domain_, kind, options_);
      std::vector<ImagePair> found;
      for (std::size_t i = 0; i < list.size(); ++i) {
        for (std::size_t k = 0; k < list[i].size(); ++k) {
          found.push_back({{static_cast<ElementIndex>(i), list[i][k]}, list.shifts_of(i)[k]});
        }
      }
      EXPECT_TRUE(found == (kind == NeighborListKind::half ? expected_ : both)) << "neighbor list";
    }
  }

  void check_detector() {
    Detector detector(options_);
    for (int call = 0; call < 2; ++call) {
      EXPECT_TRUE(image_pairs(detector.find_contact_pairs(view_, domain_)) == expected_)
          << "detector";
    }
  }

  ElementView view_;
  const Domain& domain_;
  Options options_;
  const std::vector<ImagePair>& expected_;
};

void check_two_sets(const ExtremeSystem& system) {
  std::vector<std::size_t> numbers[2];
  for (std::size_t k = 0; k < system.scene.size(); ++k) numbers[k % 3 == 0].push_back(k);
  const Scene first = part_of(system.scene, numbers[0]);
  const Scene second = part_of(system.scene, numbers[1]);
  const auto pairs_by = [&](Algorithm algorithm) {
    return image_pairs(find_contact_pairs(view_of(first), view_of(second), system.domain,
                                          options_of(system, algorithm)));
  };
  EXPECT_TRUE(pairs_by(Algorithm::rows) == pairs_by(Algorithm::direct_check)) << "two sets";
}

void check_boxes(const ExtremeSystem& system) {
  const BoxScene boxes = scenes::boxes_in(system.scene, 5);
  const auto expected = image_pairs(find_contact_pairs(
      view_of(boxes), system.domain, options_of(system, Algorithm::direct_check)));
  Faces(view_of(boxes), system.domain, options_of(system, Algorithm::rows), expected).check_all();
}

struct Cross {
  DomainKind kind;
  Extreme extreme;

  friend std::ostream& operator<<(std::ostream& out, const Cross& cross) {
    return out << name_of(cross.kind) << ", " << name_of(cross.extreme);
  }
};

std::vector<Cross> all_crosses() {
  std::vector<Cross> all;
  for (const DomainKind kind : domain_kinds) {
    for (const Extreme extreme : extremes) all.push_back({kind, extreme});
  }
  return all;
}

class PeriodicExtremes : public ::testing::TestWithParam<Cross> {
 protected:
  void check(int dimensions, std::size_t count, std::uint64_t seed) {
    const auto [kind, extreme] = GetParam();
    const ExtremeSystem system = extreme_system(kind, extreme, dimensions, count, seed);
    SCOPED_TRACE(::testing::Message() << GetParam() << ", " << dimensions << "D, " << count
                                      << " elements, seed " << seed);
    const auto expected = image_pairs(find_contact_pairs(
        view_of(system.scene), system.domain, options_of(system, Algorithm::direct_check)));
    if (count <= few) {
      const auto exact =
          dimensions == 2 ? pairs_in_rationals<2>(system) : pairs_in_rationals<3>(system);
      EXPECT_TRUE(expected == exact)
          << "direct_check: " << expected.size() << " pairs for " << exact.size();
    }
    Faces(view_of(system.scene), system.domain, options_of(system, Algorithm::rows), expected)
        .check_all();
    check_two_sets(system);
    if (count > 0) Faces::check_skin(system);
    check_boxes(system);
    pairs_ += expected.size();
    for (const ImagePair& pair : expected) across_faces_ += pair.shift != ImageShift{};
  }

  static constexpr std::size_t few = 12;
  std::size_t pairs_ = 0;
  std::size_t across_faces_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Crosses, PeriodicExtremes, ::testing::ValuesIn(all_crosses()));

TEST_P(PeriodicExtremes, EveryFaceTellsTheSamePairs) {
  for (const int dimensions : {2, 3}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      for (const std::size_t count : {1, 2, 12}) check(dimensions, count, 16 * seed + count);
    }
    check(dimensions, 0, 99);
    check(dimensions, GetParam().kind == DomainKind::small_cell ? 25 : 200, 100);
  }
  EXPECT_GT(pairs_, 5U);
  if (GetParam().kind != DomainKind::open) {
    EXPECT_GT(across_faces_, 1U);
  }
}

/// Elements with the axes of space turned round.
std::vector<HandMade> turned(std::vector<HandMade> elements, std::size_t by) {
  for (HandMade& e : elements) {
    if (by == 1) e = {e.z, e.x, e.y, e.radius};
    if (by == 2) e = {e.y, e.z, e.x, e.radius};
  }
  return elements;
}

/// Periodic with that side on all axes but the first, turned round.
Domain slit(double side, std::size_t by) {
  std::array<double, 3> lengths{side, side, side};
  lengths[by] = unbounded;
  return Domain::periodic(lengths);
}

/// Elements far out on an open axis make cells far larger than the reach, and so does a scale at
/// which a cell cannot be as small as the reach: contacts across the faces stay.
TEST(FarStrays, LeaveContactsAcrossFaces) {
  const auto count = [](const std::vector<HandMade>& elements, double side, std::size_t by,
                        Simd level) {
    const Options options{.algorithm = Algorithm::rows, .simd = level};
    return count_contact_pairs(view_of(scene_of(3, turned(elements, by))), slit(side, by), options)
        .contact_pairs;
  };
  std::vector<HandMade> elements{{0, 0.5, 0.5, 0.1},
                                 {0, 0.05, 0.5, 0.1},
                                 {0, 0.95, 0.5, 0.1},
                                 {0.3, 0.5, 0.02, 0.1},
                                 {0.3, 0.5, 0.98, 0.1}};
  for (const Simd level : simd_levels_here()) {
    for (const std::size_t by : {0U, 1U, 2U}) {
      SCOPED_TRACE(::testing::Message() << name_of(level) << ", axes turned by " << by);
      for (int exponent = 60; exponent < 1024; exponent += 9) {
        elements[0].x = std::ldexp(1.0, exponent);
        EXPECT_EQ(count(elements, 1.0, by, level), 2U) << "2^" << exponent;
      }
      elements[0].x = 5.0;
      for (int exponent = -1060; exponent < 1015; exponent += 9) {
        std::vector<HandMade> scaled = elements;
        for (HandMade& e : scaled) {
          e = {std::ldexp(e.x, exponent), std::ldexp(e.y, exponent), std::ldexp(e.z, exponent),
               std::ldexp(e.radius, exponent)};
        }
        EXPECT_EQ(count(scaled, std::ldexp(1.0, exponent), by, level), 2U)
            << "scale 2^" << exponent;
      }
    }
  }
}

/// The same in a strip, where single elements are asked which cells they lie near.
TEST(FarStrays, LeaveContactsAcrossTheFacesOfAStrip) {
  for (const Simd level : simd_levels_here()) {
    const Options options{.algorithm = Algorithm::rows, .simd = level};
    for (int exponent = 60; exponent < 1024; exponent += 9) {
      const Scene scene = scene_of(
          2, {{0.5, std::ldexp(1.0, exponent), 0, 0.1}, {0.05, 0, 0, 0.1}, {0.95, 0, 0, 0.1}});
      EXPECT_EQ(count_contact_pairs(view_of(scene), Domain::periodic({1.0, unbounded}), options)
                    .contact_pairs,
                1U)
          << name_of(level) << ", 2^" << exponent;
    }
  }
}

/// However long a cell is along one axis, elements have images along the others only as far as they
/// reach there.
TEST(LongCell, CostsNoMoreThanAShortOne) {
  std::vector<HandMade> elements;
  for (int k = 1; k <= 100; ++k) elements.push_back({1.0 * k, 0.5 + 0.49 * (k % 3 - 1), 0.5, 0.1});
  const Scene scene = scene_of(3, elements);
  for (const double length : {1e3, 1e12, 1e15, 1e18, 1e30, 1e45}) {
    std::vector<Domain> domains{
        Domain::periodic({length, 1.0, 1.0}), Domain::periodic({length, 1.0, unbounded}),
        Domain::lattice({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, length})};
    // A short basis of a sheared one takes many vectors from each other.
    if (length < 0x1p60) domains.push_back(Domain::lees_edwards({length, 1.0, 1.0}, 0.25));
    for (const Domain& domain : domains) {
      for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
        Options options{.algorithm = algorithm};
        int polls = 0;
        options.progress = [&polls](const Progress&) {
          return ++polls < 1000 ? ProgressAction::proceed : ProgressAction::cancel;
        };
        const Statistics statistics = count_contact_pairs(view_of(scene), domain, options);
        EXPECT_LT(statistics.candidate_tests, 60000U) << name_of(algorithm) << ", " << length;
        EXPECT_LT(statistics.peak_bytes, 1U << 20) << name_of(algorithm) << ", " << length;
      }
    }
  }
}

/// Many elements close together in a cell that is far longer than where they are: cells of the
/// search are not larger than they would be in a short one.
TEST(LongCell, HasCellsAsSmallAsTheReach) {
  const Scene scene = scenes::scene_named("dense").make(4000, 1);
  double side = 0.0;
  for (const double x : scene.x) side = std::max(side, x);
  const Options options{.algorithm = Algorithm::rows, .threads = 1};
  const auto tests_in = [&](double length) {
    const Domain domain = Domain::periodic({length, 2.0 * side, 2.0 * side});
    return count_contact_pairs(view_of(scene), domain, options).candidate_tests;
  };
  EXPECT_LE(tests_in(1e17), tests_in(4.0 * side) * 11 / 10);
}

/// Sums of radii and margin that overflow do not make the window of images infinite.
TEST(LongCell, MayHaveAReachThatOverflows) {
  const Scene scene = scene_of(2, {{1, 0.5, 0, 1e308}, {2, 0.5, 0, 1e308}, {3, 0.5, 0, 0.1}});
  for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
    const Options options{.algorithm = algorithm, .margin = 1.7e308};
    EXPECT_EQ(count_contact_pairs(view_of(scene), Domain::periodic({1e308, unbounded}), options)
                  .contact_pairs,
              7U + 5U + 5U + 3U + 3U + 1U)
        << name_of(algorithm);
  }
}

/// Elements near each other, but more than 2^31 - 1 cells away from the cell at the origin.
TEST(FarCells, AreRefusedByAllAlgorithmsAlike) {
  const Domain square = Domain::periodic({1.0, 1.0});
  for (const double x : {0x1p31 - 2.0, 0x1p31 + 2.0, -0x1p40}) {
    const Scene scene = scene_of(2, {{x, 0.5, 0, 0.125}, {x + 0.25, 0.5, 0, 0.125}});
    for (const Algorithm algorithm : {Algorithm::direct_check, Algorithm::rows}) {
      const Options options{.algorithm = algorithm};
      if (x == 0x1p31 - 2.0) {
        EXPECT_EQ(count_contact_pairs(view_of(scene), square, options).contact_pairs, 1U);
        continue;
      }
      expect_error(ErrorCode::invalid_input, {"element 0 has x", "2147483647 cells outside"}, [&] {
        static_cast<void>(count_contact_pairs(view_of(scene), square, options));
      });
    }
  }
}

/// One element in a cell far smaller than its reach: a hundred million pairs with itself.
class LongReach : public ::testing::TestWithParam<Algorithm> {
 protected:
  Scene scene_ = scene_of(3, {{0, 0, 0, 0.5}});
  Domain domain_ = Domain::periodic({1e-8, unbounded, unbounded});
};

INSTANTIATE_TEST_SUITE_P(Algorithms, LongReach,
                         ::testing::Values(Algorithm::direct_check, Algorithm::rows));

TEST_P(LongReach, MeetsTheLimitOfPairsAndOfMemoryEarly) {
  Options options{.algorithm = GetParam(), .max_pairs = 1000000};
  expect_error(ErrorCode::limit_exceeded, {"1000000"},
               [&] { static_cast<void>(count_contact_pairs(view_of(scene_), domain_, options)); });
  options.max_pairs = unlimited_pairs;
  options.max_bytes = 4000000;
  expect_error(ErrorCode::limit_exceeded, {"4000000"},
               [&] { static_cast<void>(find_contact_pairs(view_of(scene_), domain_, options)); });
}

TEST_P(LongReach, AsksTheHookAfterABoundedNumberOfTests) {
  Options options{.algorithm = GetParam()};
  int polls = 0;
  options.progress = [&polls](const Progress& progress) {
    if (progress.phase != "search") return ProgressAction::proceed;
    return ++polls < 5 ? ProgressAction::proceed : ProgressAction::cancel;
  };
  PairCount visited = 0;
  expect_error(ErrorCode::cancelled, {"search"}, [&] {
    for_each_contact_pair(view_of(scene_), domain_, options, [&](ContactPair) { ++visited; });
  });
  EXPECT_LT(visited, 5U << 18);
  EXPECT_GT(visited, 1U << 18);
}

}  // namespace
}  // namespace abut::testing
