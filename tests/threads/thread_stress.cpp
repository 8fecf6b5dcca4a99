// Every form of detection with four workers, compared with one: for the thread sanitizer
// (scripts/find-races), which sees races only in what really runs at the same time.
// Exit code 1 where the results differ.

#include "scenes/scene.hpp"
#include "support/crowded_systems.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <stdexcept>
#include <string>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr int workers = 4;

void insist(bool right, const std::string& what) {
  if (!right) throw std::logic_error(what + " with several workers differs from that with one");
}

void compare_lists(Detector& detector, const ElementView& elements, Options options) {
  for (const Order order : {Order::canonical, Order::as_found}) {
    options.order = order;
    options.threads = 1;
    const PairList expected = find_contact_pairs(elements, Domain::open(), options);
    options.threads = workers;
    detector.set_options(options);
    for (int again = 0; again < 2; ++again) {
      const PairList& found = detector.find_contact_pairs(elements);
      insist(std::ranges::equal(expected.pairs(), found.pairs()), "the list");
      insist(found.statistics().threads == workers, "the number of threads");
      insist(found.statistics().candidate_tests == expected.statistics().candidate_tests,
             "the count of tests");
    }
  }
}

void compare_the_rest(Detector& detector, const ElementView& elements, Options options) {
  options.threads = 1;
  const NeighborList expected =
      build_neighbor_list(elements, Domain::open(), NeighborListKind::full, options);
  const NeighborList& list =
      detector.build_neighbor_list(elements, Domain::open(), NeighborListKind::full);
  insist(std::ranges::equal(expected.offsets(), list.offsets()), "offsets of neighbors");
  insist(std::ranges::equal(expected.neighbors(), list.neighbors()), "the neighbor list");

  const PairCount pairs = expected.statistics().contact_pairs;
  insist(detector.count_contact_pairs(elements).contact_pairs == pairs, "the count");
  std::atomic<PairCount> visited = 0;
  detector.for_each_batch(
      elements, Domain::open(),
      [&](std::span<const ContactPair> batch, WorkerNumber) { visited += batch.size(); });
  insist(visited == pairs, "the number of pairs visited");
}

void stop_half_way(const ElementView& elements, Options options) {
  options.threads = workers;
  bool stopped = false;
  try {
    std::atomic<int> batches = 0;
    for_each_batch(elements, Domain::open(), options,
                   [&](std::span<const ContactPair>, WorkerNumber) {
                     if (++batches == 2) throw std::runtime_error("enough");
                   });
  } catch (const std::runtime_error&) {
    stopped = true;
  }
  insist(stopped, "an exception of the visitor");
}

void stress(const Scene& scene, double margin) {
  const ElementView elements = view_of(scene);
  const Options options{.algorithm = Algorithm::rows, .margin = margin};
  Detector detector;
  compare_lists(detector, elements, options);
  compare_the_rest(detector, elements, options);
}

void run() {
  for (const char* name : {"hexagonal_2d", "gas", "clusters", "log_uniform", "one_giant"}) {
    stress(scenes::scene_named(name).make(8000, 1), 0.0);
  }
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const CrowdedSystem system = crowded_system(seed % 2 == 0 ? 2 : 3, 2000, seed);
    stress(system.scene, system.margin);
  }
  // Groups that wait until all workers are free.
  stress(scenes::scene_named("two_far_clusters").make(70000, 1), 0.0);
  const Scene gas = scenes::scene_named("gas").make(60000, 1);
  for (int k = 0; k < 3; ++k) stop_half_way(view_of(gas), {.algorithm = Algorithm::rows});
}

}  // namespace
}  // namespace abut::testing

int main() {
  try {
    abut::testing::run();
  } catch (const std::exception& error) {
    std::cerr << "thread_stress: " << error.what() << '\n';
    return 1;
  }
}
