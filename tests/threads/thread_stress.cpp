// Every form of detection with four workers, compared with one: for the thread sanitizer
// (scripts/find-races), which sees races only in what really runs at the same time.
// Exit code 1 where the results differ.

#include "scenes/many_scales.hpp"
#include "scenes/scene.hpp"
#include "support/crowded_systems.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

void insist_equal(const PairList& expected, const PairList& found, const std::string& what) {
  insist(std::ranges::equal(expected.pairs(), found.pairs()), what);
  insist(std::ranges::equal(expected.shifts(), found.shifts()), "shifts of " + what);
}

/// Elements at home and up to a cell outside, with ghosts around the cell or in it; neighbors with
/// all that is told of them.
void stress_domains(Scene scene) {
  const double side = *std::ranges::max_element(scene.x) + scene.radius[0];
  const Domain block = Domain::periodic({side, side, side});
  const Domain oblique =
      Domain::lattice({side, 0.1 * side, 0}, {0, side, 0.2 * side}, {0.3 * side, 0, side});
  for (const double farther : {0.0, side}) {
    for (std::size_t k = 0; k < scene.x.size(); k += 3) scene.x[k] += farther;
    for (const Domain& domain : {block, oblique}) {
      Options options{.algorithm = Algorithm::rows, .shifts = Shifts::stored, .threads = 1};
      for (const Order order : {Order::canonical, Order::as_found}) {
        options.order = order;
        const PairList expected = find_contact_pairs(view_of(scene), domain, options);
        Options several = options;
        several.threads = workers;
        insist_equal(expected, find_contact_pairs(view_of(scene), domain, several),
                     "the periodic list");
      }
      options.quantities = Quantity::distance | Quantity::vector;
      const NeighborList expected =
          build_neighbor_list(view_of(scene), domain, NeighborListKind::full, options);
      options.threads = workers;
      const NeighborList found =
          build_neighbor_list(view_of(scene), domain, NeighborListKind::full, options);
      insist(std::ranges::equal(expected.neighbors(), found.neighbors()), "periodic neighbors");
      insist(std::ranges::equal(expected.shifts(), found.shifts()), "shifts of neighbors");
      insist(std::ranges::equal(expected.distances(), found.distances()), "distances");
    }
  }
}

/// Steps with a skin: detections and reuses.
void stress_skin(Scene scene) {
  Detector one({.threads = 1});
  Detector several({.threads = workers});
  one.set_skin(Skin::fixed(0.2 * scene.radius[0]));
  several.set_skin(one.skin());
  for (int step = 0; step < 6; ++step) {
    insist_equal(one.find_contact_pairs(view_of(scene)), several.find_contact_pairs(view_of(scene)),
                 "the list of a step");
    for (std::size_t k = 0; k < scene.x.size(); k += 2) scene.x[k] += 0.03 * scene.radius[0];
  }
  insist(several.skin_statistics().reuses > 0, "the number of reuses");
}

/// One set against another, boxes, walls of boxes and of triangles.
void stress_sets(const Scene& scene) {
  const ElementView spheres = view_of(scene);
  std::vector<std::array<double, 3>> lower;
  std::vector<std::array<double, 3>> upper;
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t k = 0; k < scene.x.size(); ++k) {
    const double r = scene.radius[k];
    lower.push_back({scene.x[k] - r, scene.y[k] - r, scene.z[k]});
    upper.push_back({scene.x[k] + r, scene.y[k], scene.z[k] + r});
    const int first = static_cast<int>(k);
    if (k % 3 == 0 && k + 2 < scene.x.size()) triangles.push_back({first, first + 1, first + 2});
  }
  const ElementView boxes = abut::boxes(lower, upper);
  const TriangleMesh mesh(lower, triangles);
  Options one{.threads = 1};
  Options several{.threads = workers};
  insist_equal(find_contact_pairs(spheres, spheres, Domain::open(), one),
               find_contact_pairs(spheres, spheres, Domain::open(), several), "two sets");
  insist_equal(find_contact_pairs(boxes, Domain::open(), one),
               find_contact_pairs(boxes, Domain::open(), several), "boxes");
  insist(std::ranges::equal(find_box_contacts(spheres, boxes, one).contacts(),
                            find_box_contacts(spheres, boxes, several).contacts()),
         "the contacts with boxes");
  insist(std::ranges::equal(find_mesh_contacts(spheres, mesh, one).contacts(),
                            find_mesh_contacts(spheres, mesh, several).contacts()),
         "the contacts with a mesh");
}

Scene crowds_of_eight_decades(std::size_t count) {
  Scene scene = scenes::scene_named("crowds").make(count, 1);
  for (std::size_t k = 0; k < count; ++k) {
    const double distance = std::hypot(scene.x[k], scene.y[k], scene.z[k]);
    for (auto* numbers : {&scene.x, &scene.y, &scene.z}) (*numbers)[k] *= 0.1 * distance;
  }
  return scene;
}

void stress_spatial_order(const Scene& scene) {
  insist(spatial_order(view_of(scene), {.threads = workers}) ==
             spatial_order(view_of(scene), {.threads = 1}),
         "the order along space");
}

/// Values of contacts of elements that move, are wrapped and change places.
void stress_history(Scene scene) {
  const double side = *std::ranges::max_element(scene.x) + 2.0 * scene.radius[0];
  const Domain block = Domain::periodic({side, side, side});
  std::vector<std::uint64_t> ids(scene.size());
  std::iota(ids.begin(), ids.end(), std::uint64_t{0});
  ContactHistory<std::uint64_t> one({.threads = 1}), several({.threads = workers});
  for (std::size_t step = 0; step < 6; ++step) {
    const PairList list = find_contact_pairs(view_of(scene), block, {.shifts = Shifts::stored});
    for (auto* const history : {&one, &several}) {
      history->update(list, view_of(scene), block, ids);
      for (const PairCount k : history->born()) history->values()[k] = 1'000'000 * step + k;
    }
    insist(std::ranges::equal(one.values(), several.values()), "the values of contacts");
    insist(std::ranges::equal(one.born(), several.born()), "the new contacts");
    insist(std::ranges::equal(one.flipped(), several.flipped()), "the contacts turned around");
    insist(one.lost().size() == several.lost().size(), "the number of lost contacts");
    for (std::size_t k = 0; k < scene.size(); ++k) {
      scene.x[k] += 0.01 * static_cast<double>((k * 7 + step) % 13);
      if (k % 5 == step) scene.y[k] += side;
    }
    if (step == 3) {
      std::swap(ids.front(), ids.back());
      for (auto* const column : {&scene.x, &scene.y, &scene.z}) {
        std::swap(column->front(), column->back());
      }
    }
  }
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

/// Contacts with features, of the spheres of a scene with a wavy floor and with boxes.
void stress_walls(const Scene& scene) {
  constexpr int side = 20;
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      vertices.push_back({x * 2.0, y * 2.0, (x * y) % 3 * 1.0 + 4.0});
      const int a = y * (side + 1) + x;
      if (x == side || y == side) continue;
      triangles.push_back({a, a + 1, a + side + 1});
      triangles.push_back({a + 1, a + side + 2, a + side + 1});
    }
  }
  const TriangleMesh mesh(vertices, triangles);
  const std::vector<std::uint32_t> of_spheres(scene.size(), 1);
  std::vector<std::uint32_t> of_triangles;
  for (std::size_t k = 0; k < mesh.size(); ++k) of_triangles.push_back(k % 5 == 0 ? 1 : 0);
  const PairRule rule{.elements = {.groups = of_spheres}, .others = {.groups = of_triangles}};
  const ElementView spheres = view_of(scene);
  for (const Domain& domain : {Domain::open(), Domain::periodic({40.0, 40.0, unbounded})}) {
    for (const bool ruled : {false, true}) {
      Options options{.shifts = Shifts::stored};
      if (ruled) options.rule = rule;
      options.threads = 1;
      const MeshContactList expected = find_mesh_contacts(spheres, mesh, domain, options);
      const BoxContactList of_boxes =
          find_box_contacts(spheres, mesh.boxes().view(), domain, options);
      insist(!expected.empty() && !of_boxes.empty(), "having contacts with walls");
      options.threads = workers;
      const MeshContactList found = find_mesh_contacts(spheres, mesh, domain, options);
      insist(std::ranges::equal(expected.contacts(), found.contacts()) &&
                 std::ranges::equal(expected.shifts(), found.shifts()),
             "the contacts with a mesh");
      const BoxContactList boxes = find_box_contacts(spheres, mesh.boxes().view(), domain, options);
      insist(std::ranges::equal(of_boxes.contacts(), boxes.contacts()) &&
                 std::ranges::equal(of_boxes.shifts(), boxes.shifts()),
             "the contacts with boxes");
    }
  }
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
  stress(scenes::scene_named("graded_1000").make(30000, 1), 0.0);  // sizes in layers
  stress(scenes::scene_named("refined").make(60000, 1), 0.0);      // levels of sizes, and visitors
  stress(crowds_of_eight_decades(90000), 0.0);                     // some of them wait
  stress_spatial_order(scenes::scene_named("dense").make(50000, 1));
  // Groups that wait until all workers are free.
  stress(scenes::scene_named("log_uniform").make(12000, 1), 0.0);  // one tile for all
  stress(scenes::scene_named("two_far_clusters").make(70000, 1), 0.0);
  for (const scenes::Radii radii : {scenes::Radii::equal, scenes::Radii::as_distance}) {
    for (const std::size_t count : {12000U, 50000U}) {  // sets within sets
      stress(scenes::spheres_of_scales({.radii = radii}, 20.0, count), 0.0);
    }
  }
  stress_domains(scenes::scene_named("dense").make(20000, 1));
  stress_skin(scenes::scene_named("dense").make(20000, 1));
  stress_history(scenes::scene_named("dense").make(20000, 1));
  stress_sets(scenes::scene_named("log_uniform").make(3000, 1));
  stress_walls(scenes::scene_named("gas").make(20000, 1));
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
