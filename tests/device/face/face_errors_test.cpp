// Bad inputs through the face of devices; after each error the same detector works.

#include "device/face/face_detection.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

Scene dense(std::size_t count) {
  return scenes::scene_named("dense").make(count, 1);
}

/// `call(detector)` is refused, and what works works before and after.
void expect_refused(ErrorCode code, std::initializer_list<std::string_view> words,
                    const std::function<void(device::Detector&)>& call) {
  const Scene scene = dense(500);
  const device::ElementCopy copy(view_of(scene));
  device::Detector detector;
  const PairVector before = pairs_of(detector.find_contact_pairs(copy.elements()).to_host());
  expect_error(code, words, [&] { call(detector); });
  EXPECT_EQ(pairs_of(detector.find_contact_pairs(copy.elements()).to_host()), before);
}

TEST(FaceErrors, ColumnsOfTheHost) {
  const Scene scene = dense(100);
  expect_refused(ErrorCode::wrong_usage, {"memory of the host"},
                 [&](device::Detector& detector) { detector.find_contact_pairs(view_of(scene)); });
  // Also where only the upper corners of boxes lie there.
  const scenes::BoxScene boxes = scenes::boxes_in(scene, 1);
  const device::ElementCopy copy(view_of(boxes));
  const auto column = [&](const ElementView::Numbers& numbers) {
    return Column<double>{reinterpret_cast<const double*>(numbers.first), boxes.size(),
                          numbers.stride_bytes};
  };
  const ElementView& there = copy.elements();
  const ElementView mixed =
      abut::boxes(column(there.lower(0)), column(there.lower(1)), column(there.lower(2)),
                  boxes.upper[0], boxes.upper[1], boxes.upper[2]);
  expect_refused(ErrorCode::wrong_usage, {"memory of the host"},
                 [&](device::Detector& detector) { detector.find_contact_pairs(mixed); });
}

TEST(FaceErrors, ColumnsWithStridesAndBadAddresses) {
  const Scene scene = dense(100);
  const device::ElementCopy copy(view_of(scene));
  const double* const first = reinterpret_cast<const double*>(copy.elements().center(0).first);
  const std::vector<double> reversed(scene.x.rbegin(), scene.x.rend());
  device::Detector detector;
  const auto count_of = [&](Column<double> column) {
    return detector.count_contact_pairs(discs(column, column, 0.5)).contact_pairs;
  };
  // Backwards from the last, and one number for all.
  EXPECT_EQ(count_of({first + 99, 100, -std::ptrdiff_t{sizeof(double)}}),
            count_contact_pairs(discs(reversed, reversed, 0.5)).contact_pairs);
  EXPECT_EQ(count_of({first, 100, 0}), 100U * 99U / 2U);
  const auto refuse = [&](Column<double> column, std::string_view word) {
    expect_error(ErrorCode::wrong_usage, {"column x", word}, [&] { count_of(column); });
  };
  refuse({nullptr, 100, sizeof(double)}, "null");
  refuse({first, 10, 12}, "aligned");
  const auto odd = reinterpret_cast<const std::byte*>(first) + 4;
  refuse({reinterpret_cast<const double*>(odd), 10, sizeof(double)}, "aligned");
  EXPECT_EQ(count_of({nullptr, 0, sizeof(double)}), 0U);
}

TEST(FaceErrors, BadElementsAreNamed) {
  for (std::vector<double> Scene::*const column :
       {&Scene::x, &Scene::y, &Scene::z, &Scene::radius}) {
    Scene scene = dense(200);
    (scene.*column)[37] = std::numeric_limits<double>::quiet_NaN();
    scene.radius[90] = -1.0;
    expect_refused(ErrorCode::invalid_input, {"element 37", "nan"},
                   [&](device::Detector& detector) {
                     const device::ElementCopy copy(view_of(scene));
                     detector.find_contact_pairs(copy.elements());
                   });
  }
}

/// Of two sets each may have numbers of its own precision.
TEST(FaceErrors, BadElementsOfSinglePrecisionAreNamed) {
  Scene scene = dense(200);
  scene.y[37] = std::numeric_limits<double>::infinity();
  const Float32Scene floats(scene);
  expect_refused(ErrorCode::invalid_input, {"in the second set, element 37", "y = inf"},
                 [&](device::Detector& detector) {
                   const device::ElementCopy first(view_of(dense(50)));
                   const device::ElementCopy second(floats.view());
                   detector.find_contact_pairs(first.elements(), second.elements());
                 });
}

TEST(FaceErrors, LimitsAreKept) {
  const Scene scene = dense(2000);
  const PairCount pairs = list_by_face(view_of(scene)).size();
  EXPECT_EQ(list_by_face(view_of(scene), {.max_pairs = pairs}).size(), pairs);
  const Options fewer_pairs{.max_pairs = pairs - 1};
  const Options fewer_bytes{.max_bytes = 20000};
  for (const Options& options : {fewer_pairs, fewer_bytes}) {
    expect_refused(ErrorCode::limit_exceeded, {}, [&](device::Detector& detector) {
      const device::ElementCopy copy(view_of(scene));
      const Options former = detector.options();
      detector.set_options(options);
      try {
        detector.find_contact_pairs(copy.elements());
      } catch (...) {
        detector.set_options(former);
        throw;
      }
    });
  }
}

TEST(FaceErrors, ACancelledCallLeavesNoList) {
  const Scene scene = dense(500);
  const device::ElementCopy copy(view_of(scene));
  device::Detector detector;
  const device::PairList& list = detector.find_contact_pairs(copy.elements());
  EXPECT_GT(list.size(), 0U);
  detector.set_options({.progress = [](const Progress&) { return ProgressAction::cancel; }});
  expect_error(ErrorCode::cancelled, {}, [&] { detector.find_contact_pairs(copy.elements()); });
  EXPECT_TRUE(list.empty());
  EXPECT_TRUE(list.to_host().empty());
}

TEST(FaceErrors, WhatIsNotSupported) {
  const Scene scene = dense(10);
  expect_refused(ErrorCode::wrong_usage, {"does not"}, [&](device::Detector& detector) {
    detector.set_options({.algorithm = Algorithm::direct_check});
    try {
      const device::ElementCopy copy(view_of(scene));
      detector.find_contact_pairs(copy.elements());
    } catch (...) {
      detector.set_options({});
      throw;
    }
  });
}

TEST(FaceInputs, OfNoneAndOneAndTwo) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    const Scene scene = scenes::scene_named("coincident").make(count, 1);
    EXPECT_EQ(list_by_face(view_of(scene)).size(), count * (count - 1) / 2) << count;
    EXPECT_EQ(count_by_face(view_of(scene)).contact_pairs, count * (count - 1) / 2) << count;
  }
}

/// Columns of structs are packed when they are copied, and one radius stays one number.
TEST(FaceInputs, OfStructsAndOneRadius) {
  struct Particle {
    float mass;
    double x, y, z;
  };
  const Scene scene = dense(500);
  std::vector<Particle> particles;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    particles.push_back({1.0F, scene.x[k], scene.y[k], scene.z[k]});
  }
  const ElementView structs =
      spheres(column(particles, &Particle::x), column(particles, &Particle::y),
              column(particles, &Particle::z), scene.radius[0]);
  EXPECT_EQ(pairs_of(list_by_face(structs)), pairs_of(list_by_face(view_of(scene))));
}

}  // namespace
}  // namespace abut::testing
