// The stages of the device engine with items on four threads, compared with one: for the thread
// sanitizer (scripts/find-races), which sees two items that touch one place. Exit code 1 where the
// answers differ.

#include "device/host/host_detection.hpp"
#include "scenes/box_scene.hpp"
#include "scenes/scene.hpp"
#include "support/scene_view.hpp"

#include <abut/element_view.hpp>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

/// The same run for a full neighbor list with gaps.
HostRun with_rows(HostRun run) {
  run.form = device::ListForm::full_rows;
  run.quantities = Quantity::gap;
  return run;
}

void compare(std::string_view name, std::size_t count, const Domain& domain = Domain::open()) {
  const scenes::Scene scene = scenes::scene_named(name).make(count, 1);
  const HostRun alone{.domain = domain, .shifts = Shifts::stored};
  HostRun together = alone;
  together.workers = 4;
  for (const double margin : {0.0, 0.2 * scene.radius[0]}) {
    const HostAnswer one = list_on_host(view_of(scene), margin, alone);
    const HostAnswer four = list_on_host(view_of(scene), margin, together);
    const HostAnswer counted = count_on_host(view_of(scene), margin, together);
    if (one.pairs != four.pairs || one.shifts != four.shifts || one.count != counted.count) {
      throw std::logic_error("four threads give other pairs of the scene " + std::string(name));
    }
    const HostAnswer rows = list_on_host(view_of(scene), margin, with_rows(alone));
    const HostAnswer same = list_on_host(view_of(scene), margin, with_rows(together));
    if (rows.offsets != same.offsets || rows.neighbors != same.neighbors ||
        rows.shifts != same.shifts || rows.gaps != same.gaps) {
      throw std::logic_error("four threads give other rows of the scene " + std::string(name));
    }
  }
}

/// Elements of a few groups, of which some may not pair, and exclusions.
void compare_with_rule(std::string_view name, std::size_t count, const Domain& domain) {
  const scenes::Scene scene = scenes::scene_named(name).make(count, 1);
  std::vector<std::uint32_t> groups;
  for (std::uint32_t k = 0; k < scene.size(); ++k) groups.push_back(k % 3);
  GroupTable table(3);
  table.deny(0, 1);
  HostRun run{.domain = domain, .shifts = Shifts::stored};
  const PairVector pairs = list_on_host(view_of(scene), 0.0, run).pairs;
  const std::span<const ContactPair> half(pairs.data(), pairs.size() / 2);
  const ExclusionList exclusions(half, scene.size());
  run.rule = {.elements = {.groups = groups}, .table = &table, .exclusions = &exclusions};
  const HostAnswer one = list_on_host(view_of(scene), 0.0, run);
  run.workers = 4;
  const HostAnswer four = list_on_host(view_of(scene), 0.0, run);
  if (one.pairs != four.pairs || one.shifts != four.shifts || one.count * 2 >= pairs.size()) {
    throw std::logic_error("four threads keep another rule in the scene " + std::string(name));
  }
}

/// Boxes of many sizes.
void compare_boxes(std::size_t count, const Domain& domain) {
  const scenes::BoxScene scene =
      scenes::boxes_in(scenes::scene_named("log_uniform").make(count, 1), 2);
  const auto& lower = scene.lower;
  const auto& upper = scene.upper;
  const ElementView all = boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
  HostRun run{.domain = domain, .shifts = Shifts::stored, .quantities = Quantity::gap};
  const HostAnswer one = list_on_host(all, 0.0, run);
  run.workers = 4;
  const HostAnswer four = list_on_host(all, 0.0, run);
  if (one.pairs != four.pairs || one.shifts != four.shifts || one.gaps != four.gaps ||
      one.pairs.empty()) {
    throw std::logic_error("four threads give other pairs of boxes");
  }
}

void run_all() {
  // One level, several, rows that are long, and wide gaps; many pairs in doubt.
  compare("dense", 3000);
  compare("gas_2d", 3000);
  compare("log_uniform_1000", 3000);
  compare("graded", 3000);
  compare("one_giant", 3000);
  compare("touching_fcc", 3000);
  compare("coincident", 300);
  compare("two_far_clusters", 1000);
  // Images, of elements that are moved; rows of many images.
  compare("dense", 1000, Domain::periodic({14.0, 14.0, 14.0}));
  compare("graded", 1000, Domain::lattice({40.0, 0.0, 0.0}, {8.0, 40.0, 0.0}, {0.0, 9.0, 40.0}));
  compare("dense", 4, Domain::periodic({0.7, 0.7, 0.7}));
  compare_boxes(2000, Domain::open());
  compare_boxes(500, Domain::periodic({60.0, 60.0, 60.0}));
  compare_with_rule("dense", 3000, Domain::open());
  compare_with_rule("graded", 1000, Domain::periodic({40.0, 40.0, 40.0}));
}

}  // namespace
}  // namespace abut::testing

int main() {
  try {
    abut::testing::run_all();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
