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
//   small cell     S, images_test (none), periodic_limits_test
//   long cell      S, periodic_limits_test
//   long triclinic S
//
// Strays need an axis that no vector leads along, and are none where there is no such axis.

#include "support/periodic_extremes.hpp"
#include "periodic/periodic_search.hpp"
#include "support/algorithm_list.hpp"
#include "support/box_oracle.hpp"
#include "support/periodic_oracle.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detector.hpp>
#include <abut/two_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
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
  testing::PeriodicSystem<Dim> exact;
  const std::vector<double>* const columns[] = {&system.scene.x, &system.scene.y, &system.scene.z};
  for (std::size_t k = 0; k < system.scene.size(); ++k) {
    exact::Sphere<Dim> sphere{};
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
  for (const testing::FoundPair& pair : testing::pairs_by_rationals(exact)) {
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
      for (const std::size_t count : {1U, 2U, 12U}) check(dimensions, count, 16 * seed + count);
    }
    check(dimensions, 0, 99);
    check(dimensions, GetParam().kind == DomainKind::small_cell ? 25 : 200, 100);
  }
  EXPECT_GT(pairs_, 5U);
  if (GetParam().kind != DomainKind::open) {
    EXPECT_GT(across_faces_, 1U);
  }
}

}  // namespace
}  // namespace abut::testing
