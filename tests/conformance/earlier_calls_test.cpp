// A detector that has searched other systems before finds the pairs of each in the `as_found` order
// of a new one: spheres, boxes, crowds and extremes, in open and periodic domains, where they are
// packed and where they lie, in single precision and in double.

#include "scenes/random.hpp"
#include "support/box_oracle.hpp"
#include "support/crowded_systems.hpp"
#include "support/periodic_extremes.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>
#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::BoxScene;
using scenes::Scene;

struct Found {
  std::vector<ContactPair> pairs;
  std::vector<ImageShift> shifts;
  std::uint64_t candidate_tests = 0;

  explicit Found(const PairList& list)
      : pairs(list.begin(), list.end()),
        shifts(list.shifts().begin(), list.shifts().end()),
        candidate_tests(list.statistics().candidate_tests) {}

  friend bool operator==(const Found&, const Found&) = default;
};

const Options options{
    .algorithm = Algorithm::rows, .order = Order::as_found, .shifts = Shifts::stored, .threads = 1};

/// Spheres, in single precision where that holds their numbers, or boxes in them.
enum class Given { spheres, singles, boxes };

/// A system of spheres, or of boxes in them.
class SystemApart {
 public:
  SystemApart(std::string name, Scene scene, const Domain& domain)
      : name_(std::move(name)), scene_(std::move(scene)), domain_(domain) {}

  [[nodiscard]] const std::string& name() const { return name_; }

  [[nodiscard]] Found found_by(Detector& detector, Given given) const {
    if (given == Given::boxes) {
      const BoxScene boxes = scenes::boxes_in(scene_, 5);
      return Found(detector.find_contact_pairs(view_of(boxes), domain_));
    }
    if (given == Given::singles && fits_float(scene_)) {
      const Float32Scene singles(scene_);
      return Found(detector.find_contact_pairs(singles.view(), domain_));
    }
    return Found(detector.find_contact_pairs(view_of(scene_), domain_));
  }
  [[nodiscard]] Found found_by_new_one(Given given) const {
    Detector detector(options);
    return found_by(detector, given);
  }

 private:
  std::string name_;
  Scene scene_;
  Domain domain_;
};

/// The same with numbers of single precision.
Scene rounded(const Scene& scene) {
  return Float32Scene(scene).widened;
}

/// Shears the elements, which fill a block from 0 on, and returns the cell that they fill then.
Domain sheared_around(Scene& scene) {
  constexpr double shear = 0.25;
  const double x = *std::max_element(scene.x.begin(), scene.x.end()) + 0.5;
  const double y = *std::max_element(scene.y.begin(), scene.y.end()) + 0.5;
  const double z = *std::max_element(scene.z.begin(), scene.z.end()) + 0.5;
  for (std::size_t k = 0; k < scene.size(); ++k) scene.x[k] += shear * scene.y[k];
  return Domain::lattice({x, 0.0, 0.0}, {shear * y, y, 0.0}, {0.0, 0.0, z});
}

std::vector<SystemApart> all_systems(int dimensions) {
  std::vector<SystemApart> systems;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const std::size_t count : {400U, 3000U, 11000U}) {
      systems.emplace_back("crowds " + std::to_string(seed) + ", " + std::to_string(count),
                           rounded(crowded_system(dimensions, count, seed).scene), Domain::open());
    }
  }
  for (const DomainKind kind : domain_kinds) {
    if (kind == DomainKind::small_cell) continue;
    for (const Extreme extreme : extremes) {
      const std::size_t count = extreme == Extreme::none ? 2500 : 400;
      const ExtremeSystem system = extreme_system(kind, extreme, dimensions, count, 7);
      systems.emplace_back(std::string(name_of(kind)) + ", " + std::string(name_of(extreme)),
                           system.scene, system.domain);
    }
  }
  for (const char* const name : {"dense", "gas", "touching_cubic", "bidisperse", "clusters"}) {
    if (dimensions == 2) break;
    for (const std::size_t count : {900U, 5000U, 15000U}) {
      const std::string title = std::string(name) + ", " + std::to_string(count);
      Scene scene = rounded(scenes::scene_named(name).make(count, 3));
      systems.emplace_back(title, scene, Domain::open());
      const Domain domain = sheared_around(scene);
      systems.emplace_back(title + ", sheared", rounded(scene), domain);
    }
  }
  return systems;
}

class EarlierCalls : public ::testing::TestWithParam<std::tuple<int, Given>> {};

TEST_P(EarlierCalls, DoNotChangeTheOrder) {
  const auto [dimensions, given] = GetParam();
  const std::vector<SystemApart> systems = all_systems(dimensions);
  std::vector<Found> expected;
  for (const SystemApart& system : systems) expected.push_back(system.found_by_new_one(given));
  Detector detector(options);
  scenes::Random random(31);
  std::string before = "nothing";
  for (std::size_t call = 0; call < 2 * systems.size(); ++call) {
    // Now and then the same once more.
    const std::size_t k = random.below(systems.size());
    for (std::size_t times = 1 + random.below(2); times > 0; --times) {
      const bool as_singles = given == Given::spheres && random.below(2) == 0;
      const Given given_now = as_singles ? Given::singles : given;
      EXPECT_TRUE(systems[k].found_by(detector, given_now) == expected[k])
          << systems[k].name() << " after " << before;
      before = systems[k].name();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Systems, EarlierCalls,
                         ::testing::Combine(::testing::Values(2, 3),
                                            ::testing::Values(Given::spheres, Given::boxes)));

}  // namespace
}  // namespace abut::testing
