// One pass over the caller's elements tells of their ways what the displacement tracker does, to
// the last bit, and leaves in their slots what the plain conversion does.

#include "skin/following_pass.hpp"

#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "scenes/random.hpp"
#include "skin/displacement_tracker.hpp"

#include <abut/column.hpp>
#include <abut/domain.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

template <int Dim>
using Spheres = std::vector<exact::Sphere<Dim>>;

template <int Dim>
Spheres<Dim> spheres_somewhere(std::size_t count, scenes::Random& random) {
  Spheres<Dim> spheres(count);
  for (auto& sphere : spheres) {
    for (double& x : sphere.center) x = random.uniform(-7.0, 9.0);
    sphere.radius = random.uniform(0.1, 0.5);
  }
  return spheres;
}

template <int Dim>
void move(double growth, Spheres<Dim>& spheres, scenes::Random& random) {
  for (auto& sphere : spheres) {
    for (double& x : sphere.center) x += 0.01 * std::pow(random.uniform(-1.0, 1.0), 3.0);
    if (random.below(2) == 0) sphere.radius += growth * random.uniform(0.0, 1.0);
  }
}

/// Views records, of which the numbers lie apart.
template <int Dim>
ElementView view_of(const Spheres<Dim>& spheres) {
  constexpr std::ptrdiff_t stride = sizeof(exact::Sphere<Dim>);
  std::array<Column<double>, Dim> centers{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    centers[axis] = {spheres.data()->center + axis, spheres.size(), stride};
  }
  return ElementView(centers, Column<double>{&spheres.data()->radius, spheres.size(), stride});
}

/// Views contiguous columns of the same.
template <int Dim>
class Columns {
 public:
  explicit Columns(const Spheres<Dim>& spheres) {
    for (const auto& sphere : spheres) {
      for (std::size_t axis = 0; axis < Dim; ++axis) column_[axis].push_back(sphere.center[axis]);
      column_[Dim].push_back(sphere.radius);
    }
  }
  [[nodiscard]] ElementView view() const {
    std::array<Column<double>, Dim> centers{};
    for (std::size_t axis = 0; axis < Dim; ++axis) centers[axis] = column(column_[axis]);
    return ElementView(centers, column(column_[Dim]));
  }

 private:
  std::array<std::vector<double>, Dim + 1> column_;
};

/// What the tracker says of gathered elements.
template <int Dim>
double approach_of(const Spheres<Dim>& then, const Spheres<Dim>& now, base::WorkCounter& work) {
  base::MemoryMeter memory;
  skin::DisplacementTracker<Dim> tracker(memory);
  const grid::Bounds<Dim> unused;
  const Domain domain = Domain::open();
  const skin::CallNow call{domain, 0.0, 1, Simd::scalar, work};
  EXPECT_TRUE(tracker.start({call, then, unused}));
  return tracker.approach({call, now, unused}, infinite);
}

template <int Dim>
skin::Quanta<Dim> some_quanta() {
  std::array<double, Dim> middle{};
  middle.fill(0.7);
  return {20.0, middle};
}

template <int Dim>
void expect_the_same(std::size_t count, double growth) {
  scenes::Random random(1000 + count);
  base::ProgressReporter progress;
  base::WorkCounter work(progress, 0);
  const Domain domain = Domain::open();
  const Spheres<Dim> then = spheres_somewhere<Dim>(count, random);
  Spheres<Dim> now = then;
  move(growth, now, random);
  const double approach = approach_of<Dim>(then, now, work);
  const skin::Quanta<Dim> quanta = some_quanta<Dim>();
  const Columns<Dim> columns(now);
  for (const Simd simd : simd_levels()) {
    if (!available(simd)) continue;
    for (const std::size_t workers : {1u, 3u}) {
      for (const ElementView& given : {view_of<Dim>(now), columns.view()}) {
        const skin::CallNow call{domain, 0.0, workers, simd, work};
        std::vector<kernels::QuantumSphere> slots(count);
        const auto follow = [&](double allowed) {
          return skin::follow<Dim>({given, then, quanta, slots, nullptr}, call, allowed);
        };
        ASSERT_EQ(follow(1.0), approach) << name_of(simd);
        for (std::size_t k = 0; k < count; ++k) {
          const kernels::QuantumSphere slot = quanta.of(now[k]);
          const auto numbers = [](const kernels::QuantumSphere& s) {
            return std::tuple(s.center[0], s.center[1], s.center[2], s.radius);
          };
          ASSERT_EQ(numbers(slots[k]), numbers(slot)) << name_of(simd) << ' ' << k;
        }
        ASSERT_EQ(follow(approach), approach);
        ASSERT_EQ(follow(std::nextafter(approach, 0.0)), infinite);
      }
    }
  }
}

TEST(FollowingPass, TellsWhatTheTrackerTells) {
  for (const std::size_t count : {1u, 2u, 7u, 64u, 1023u, 1025u, 5000u}) {
    for (const double growth : {0.0, 0.01, -0.01}) {
      SCOPED_TRACE(std::to_string(count) + " growing by " + std::to_string(growth));
      expect_the_same<2>(count, growth);
      expect_the_same<3>(count, growth);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

/// A slot for most elements, in any order; the others have none.
std::vector<std::uint32_t> slots_anywhere(std::size_t count, std::size_t& slot_count,
                                          scenes::Random& random) {
  std::vector<std::uint32_t> slot_of(count, std::numeric_limits<std::uint32_t>::max());
  slot_count = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (random.below(8) > 0) slot_of[k] = static_cast<std::uint32_t>(slot_count++);
  }
  for (std::size_t k = count; k > 1; --k) std::swap(slot_of[k - 1], slot_of[random.below(k)]);
  return slot_of;
}

/// Whatever stood in the slots; behind the last one nothing is written.
TEST(FollowingPass, FillsSlotsAnywhere) {
  base::ProgressReporter progress;
  base::WorkCounter work(progress, 0);
  const Domain domain = Domain::open();
  for (const std::size_t count : {1u, 63u, 512u, 513u, 2000u}) {
    scenes::Random random(count);
    const Spheres<3> then = spheres_somewhere<3>(count, random);
    Spheres<3> now = then;
    move(0.01, now, random);
    const Columns<3> columns(now);
    const auto quanta = some_quanta<3>();
    std::size_t slot_count = 0;
    const std::vector<std::uint32_t> slot_of = slots_anywhere(count, slot_count, random);
    for (const Simd simd : simd_levels()) {
      if (!available(simd)) continue;
      for (const std::size_t workers : {1u, 3u}) {
        const skin::CallNow call{domain, 0.0, workers, simd, work};
        std::vector<kernels::QuantumSphere> slots(slot_count + 1, {{-1, -1, -1}, -1});
        const std::span used = std::span(slots).first(slot_count);
        const double approach =
            skin::follow<3>({columns.view(), then, quanta, used, slot_of.data()}, call, infinite);
        EXPECT_EQ(approach, approach_of<3>(then, now, work));
        for (std::size_t k = 0; k < count; ++k) {
          if (slot_of[k] >= slot_count) continue;
          const kernels::QuantumSphere expected = quanta.of(now[k]), found = slots[slot_of[k]];
          ASSERT_TRUE(std::ranges::equal(found.center, expected.center)) << k;
          ASSERT_EQ(found.radius, expected.radius) << k;
        }
        EXPECT_EQ(slots.back().radius, -1);
      }
    }
  }
}

/// Wherever it stands: in a whole vector or behind the last.
TEST(FollowingPass, LeavesWhatIsStrangeToOthers) {
  constexpr std::size_t count = 21;
  scenes::Random random(3);
  base::ProgressReporter progress;
  base::WorkCounter work(progress, 0);
  const Domain domain = Domain::open();
  const Spheres<3> then = spheres_somewhere<3>(count, random);
  std::vector<kernels::QuantumSphere> slots(count);
  const auto spoil_center = [](double x) {
    return [x](exact::Sphere<3>& sphere) { sphere.center[1] = x; };
  };
  const auto spoil_radius = [](double r) {
    return [r](exact::Sphere<3>& sphere) { sphere.radius = r; };
  };
  const std::vector<std::function<void(exact::Sphere<3>&)>> spoilers{
      spoil_center(nan), spoil_center(infinite), spoil_center(-infinite), spoil_center(1e300),
      spoil_radius(nan), spoil_radius(infinite), spoil_radius(-1e-9),     spoil_radius(-infinite)};
  for (const Simd simd : simd_levels()) {
    if (!available(simd)) continue;
    const skin::CallNow call{domain, 0.0, 1, simd, work};
    for (std::size_t k = 0; k < count; ++k) {
      for (const auto& spoil : spoilers) {
        Spheres<3> now = then;
        spoil(now[k]);
        const Columns<3> columns(now);
        const auto quanta = some_quanta<3>();
        const double most = std::numeric_limits<double>::max();
        ASSERT_EQ(skin::follow<3>({columns.view(), then, quanta, slots, nullptr}, call, most),
                  infinite);
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
