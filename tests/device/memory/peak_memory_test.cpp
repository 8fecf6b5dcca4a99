// The most bytes that a detection holds, in each kind of domain and of each kind of elements: 64
// for each element and each ghost and 16 for each pair, or less, in the first call and in those
// after.

#include "device/host/host_detection.hpp"
#include "device/memory/host_memory.hpp"
#include "device/memory/peak_scenes.hpp"
#include "device/scene_in_two.hpp"
#include "scenes/box_scene.hpp"
#include "support/box_oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/device.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::testing {
namespace {

using scenes::Scene;

/// What does not follow the number of elements where 100 items are counted at a time.
constexpr std::uint64_t fixed = 8192;

void expect_at_most(std::uint64_t bytes, const HostAnswer& answer) {
  const std::uint64_t listed =
      std::max<std::uint64_t>(answer.pairs.size(), answer.neighbors.size());
  const std::uint64_t of_pairs = 16 * (listed + answer.exact_decisions);
  EXPECT_LE(answer.peak_bytes, bytes * answer.searched + of_pairs + fixed)
      << "pairs apart "
      << (static_cast<double>(answer.peak_bytes) - static_cast<double>(of_pairs)) /
             static_cast<double>(answer.searched)
      << " an element";
}

/// In the first call, whose blocks are taken one by one, and in those that follow it, whose blocks
/// lie in one array.
template <class Call>
void expect_at_most(std::uint64_t bytes, HostRun run, int calls, const Call& call) {
  device::KeptMemory kept(memory_of_the_host());
  run.items_at_a_time = 100;
  run.kept = &kept;
  for (int k = 1; k <= calls; ++k) {
    SCOPED_TRACE(::testing::Message() << "call " << k);
    expect_at_most(bytes, call(run));
  }
}

/// Whatever is asked for.
void expect_at_most(std::uint64_t bytes, const ElementView& elements, HostRun run) {
  const auto list = [&](const HostRun& its_run) { return list_on_host(elements, 0.0, its_run); };
  const auto count = [&](const HostRun& its_run) { return count_on_host(elements, 0.0, its_run); };
  expect_at_most(bytes, run, 3, list);
  expect_at_most(bytes, run, 2, count);
  run.form = device::ListForm::full_rows;
  expect_at_most(bytes, run, 2, list);
}

/// Of spheres, of boxes and of two sets.
void expect_at_most(std::uint64_t bytes, const Scene& scene, const Domain& domain) {
  expect_at_most(bytes, view_of(scene), {.domain = domain});
  const scenes::BoxScene boxes = scenes::boxes_in(scene, 6);
  expect_at_most(bytes, view_of(boxes), {.domain = domain});
  const SceneInTwo sets(scene);
  const ElementView second = view_of(sets.second);
  expect_at_most(bytes, view_of(sets.first), {.domain = domain, .second = &second});
}

TEST(DevicePeak, InACompactDomain) {
  for (const Scene& scene : compact_scenes(4000)) expect_at_most(48, scene, Domain::open());
}

/// As given, and with elements some cells out, which are moved; ghosts are few and many.
TEST(DevicePeak, InAPeriodicDomain) {
  for (const std::size_t count : {std::size_t{300}, std::size_t{2000}}) {
    for (Scene& scene : compact_scenes(count)) {
      const double side = side_of(scene);
      const Domain cell = cell_of(scene, side);
      expect_at_most(56, scene, cell);
      for (std::size_t k = 0; k < scene.size(); k += 2) scene.x[k] += 3.0 * side;
      expect_at_most(56, scene, cell);
    }
  }
}

TEST(DevicePeak, InAWideDomain) {
  for (const std::size_t count : {std::size_t{400}, std::size_t{4000}}) {
    for (const Scene& scene : wide_scenes(count)) expect_at_most(56, scene, Domain::open());
  }
}

/// Wide along open axes, with a periodic face; and wide in a cell that is as wide.
TEST(DevicePeak, InAWidePeriodicDomain) {
  for (const Scene& scene : wide_scenes(600)) {
    const double side = side_of(scene);
    for (const double length : {0.25 * side, side}) {
      expect_at_most(64, scene, Domain::periodic({length, unbounded, unbounded}));
      expect_at_most(64, scene, Domain::periodic({length, length, length}));
    }
  }
}

/// So many cells out that one word does not tell how many.
TEST(DevicePeak, OfElementsFarOut) {
  for (Scene& scene : compact_scenes(1500)) {
    const double side = side_of(scene);
    for (std::size_t k = 0; k < scene.size(); k += 2) {
      for (auto* const column : {&scene.x, &scene.y, &scene.z}) {
        if (!column->empty()) (*column)[k] += 0x1p25 * side;
      }
    }
    expect_at_most(64, scene, cell_of(scene, side));
  }
}

}  // namespace
}  // namespace abut::testing
