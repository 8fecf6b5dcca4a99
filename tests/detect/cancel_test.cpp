// A cancel at any question of any call: the call ends at once, and what is called next works.

#include "detect/asking_hook.hpp"
#include "support/algorithm_list.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// A detection that is cancelled at any question.
struct Face {
  std::string name;
  /// Makes a detection; what it returns tells its result.
  std::function<std::vector<std::uint64_t>(const Options&)> detect;
};

std::vector<std::uint64_t> told(std::span<const ContactPair> pairs) {
  std::vector<std::uint64_t> result;
  for (const ContactPair& pair : pairs) {
    result.push_back(std::uint64_t{pair.first} << 32 | pair.second);
  }
  return result;
}

std::vector<std::uint64_t> told(const NeighborList& list) {
  std::vector<std::uint64_t> result(list.neighbors().begin(), list.neighbors().end());
  result.insert(result.end(), list.offsets().begin(), list.offsets().end());
  return result;
}

const Scene& small_crowd() {
  return crowd(400);
}

const Scene& packing() {
  static const Scene made = scenes::scene_named("dense").make(4000, 1);
  return made;
}

const Domain& cell() {
  static const Domain made = Domain::periodic(std::array{40.0, 40.0, 40.0});
  return made;
}

std::vector<Face> faces() {
  std::vector<Face> result;
  result.push_back({"list", [](const Options& options) {
                      return told(
                          find_contact_pairs(view_of(small_crowd()), Domain::open(), options));
                    }});
  result.push_back({"periodic list", [](const Options& options) {
                      return told(find_contact_pairs(view_of(packing()), cell(), options));
                    }});
  result.push_back(
      {"count", [](const Options& options) {
         return std::vector{
             count_contact_pairs(view_of(packing()), Domain::open(), options).contact_pairs};
       }});
  result.push_back({"two sets", [](const Options& options) {
                      return told(find_contact_pairs(view_of(packing()), view_of(small_crowd()),
                                                     Domain::open(), options));
                    }});
  result.push_back({"neighbor list", [](const Options& options) {
                      Options measured = options;
                      measured.quantities = Quantity::distance;
                      return told(build_neighbor_list(view_of(small_crowd()), Domain::open(),
                                                      NeighborListKind::full, measured));
                    }});
  result.push_back({"periodic neighbor list", [](const Options& options) {
                      return told(build_neighbor_list(view_of(packing()), cell(),
                                                      NeighborListKind::half, options));
                    }});
  return result;
}

/// `detect(options)` is called with a hook that cancels at the first question, at the second, ...
/// until one passes.
void cancel_at_each(const Options& plain,
                    const std::function<std::vector<std::uint64_t>(const Options&)>& detect) {
  const auto expected = detect(plain);
  constexpr std::uint64_t most = 2000;
  for (std::uint64_t k = 1; k < most; ++k) {
    Hook hook;
    hook.cancelled_at = k;
    Options options = plain;
    options.progress = hook.hook();
    try {
      EXPECT_EQ(detect(options), expected);
      EXPECT_LT(hook.all, k);
      EXPECT_GT(k, 3U);
      return;
    } catch (const Error& error) {
      ASSERT_EQ(error.code(), ErrorCode::cancelled) << error.what();
      ASSERT_EQ(hook.all, k);
    }
  }
  FAIL() << "asked more than " << most << " times";
}

TEST(Cancel, AtEachQuestionOfEachFace) {
  for (const Face& face : faces()) {
    for (const Algorithm algorithm : {Algorithm::rows, Algorithm::munjiza_nbs}) {
      const bool many_boxes = algorithm == Algorithm::munjiza_nbs;
      if (many_boxes && face.name.starts_with("periodic")) continue;
      for (const int threads : {1, 2}) {
        SCOPED_TRACE(face.name + ", " + std::string(name_of(algorithm)) + ", threads " +
                     std::to_string(threads));
        Options options;
        options.algorithm = algorithm;
        options.threads = threads;
        cancel_at_each(options, face.detect);
      }
    }
  }
}

TEST(Cancel, AtEachQuestionOfEachAlgorithm) {
  for (const Algorithm algorithm : algorithms_for(3)) {
    SCOPED_TRACE(std::string(name_of(algorithm)));
    Options options;
    options.algorithm = algorithm;
    options.threads = 1;
    cancel_at_each(options, [](const Options& with) {
      return told(find_contact_pairs(view_of(small_crowd()), Domain::open(), with));
    });
  }
}

/// One Detector throughout: with a skin, with ids of which some change, and for lists of both
/// kinds.
TEST(Cancel, ADetectorWorksAfterACancelAtEachQuestion) {
  for (const Domain& domain : {Domain::open(), cell()}) {
    for (const Skin skin : {Skin::none(), Skin::fixed(0.05)}) {
      Options plain;
      plain.threads = 2;
      Detector detector(plain);
      detector.set_skin(skin);
      std::vector<std::uint64_t> ids(packing().size());
      std::uint64_t first = 0;
      cancel_at_each(plain, [&](const Options& options) {
        std::iota(ids.begin(), ids.end(), ++first);
        detector.set_ids(ids);
        detector.set_options(options);
        auto all = told(detector.find_contact_pairs(view_of(packing()), domain));
        const auto rows =
            told(detector.build_neighbor_list(view_of(packing()), domain, NeighborListKind::full));
        all.insert(all.end(), rows.begin(), rows.end());
        return all;
      });
    }
  }
}

/// Sets so large that they are searched in layers.
TEST(Cancel, ADetectorWorksAfterACancelAtEachQuestionInLayers) {
  for (const char* const name : {"dense", "hexagonal_2d"}) {
    const Scene scene = scenes::scene_named(name).make(12000, 1);
    for (const int threads : {1, 2}) {
      SCOPED_TRACE(std::string(name) + ", threads " + std::to_string(threads));
      Options plain;
      plain.threads = threads;
      Detector detector(plain);
      cancel_at_each(plain, [&](const Options& options) {
        detector.set_options(options);
        return told(detector.find_contact_pairs(view_of(scene), Domain::open()));
      });
    }
  }
}

TEST(Cancel, AtEachQuestionOfTheContactsWithWalls) {
  const std::vector<double> low{-5.0, 20.0}, high{200.0, 21.0};
  const ElementView walls = boxes(low, low, low, high, high, high);
  Options options;
  options.threads = 2;
  cancel_at_each(options, [&](const Options& with) {
    std::vector<std::uint64_t> result;
    for (const BoxContact& contact : find_box_contacts(view_of(packing()), walls, with)) {
      result.push_back(std::uint64_t{contact.sphere} << 32 | contact.box);
    }
    return result;
  });
}

}  // namespace
}  // namespace abut::testing
