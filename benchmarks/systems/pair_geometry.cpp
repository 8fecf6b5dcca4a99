// Times what is measured of a contact, in nanoseconds of processor time: each quantity of the pairs
// of a scene, and all of a periodic neighbor list (numbers, distances, vectors, shifts). CSV on
// stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/random.hpp"
#include "scenes/scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

struct Settings {
  std::string scene = "dense";
  std::size_t count = 1'000'000;
  std::size_t atoms = 100'000;
  int repetitions = 9;
};

/// One line of the table: nanoseconds for each of `entries`.
void write(const std::string& task, std::size_t elements, PairCount entries, int repetitions,
           const std::function<void()>& work) {
  work();
  std::vector<double> seconds;
  for (int k = 0; k < repetitions; ++k) seconds.push_back(processor_seconds(work));
  const MedianAndMinimum found = median_and_minimum(seconds);
  const double ns = 1e9 / static_cast<double>(entries);
  std::printf("%s,%zu,%llu,%.2f,%.2f\n", task.c_str(), elements,
              static_cast<unsigned long long>(entries), found.minimum * ns, found.median * ns);
}

/// One call for each pair.
void measure_calls(const ElementView& elements, const PairList& list, int repetitions) {
  double sum = 0.0;
  write("gap() of one pair", elements.size(), list.size(), repetitions, [&] {
    for (const ContactPair pair : list) sum += gap(elements, pair);
  });
  if (std::isnan(sum)) std::puts("a gap is not a number");
}

void measure_scene(const Settings& settings) {
  const scenes::Scene scene = scenes::scene_named(settings.scene).make(settings.count, 1);
  const ElementView elements = spheres(scene.x, scene.y, scene.z, scene.radius);
  const PairList list = find_contact_pairs(elements, Domain::open(), {.threads = 1});
  const PairMeasurer measurer(elements, Domain::open(), {.threads = 1});
  const auto row = [&](const char* task, Quantities quantities) {
    PairGeometry geometry = measure(elements, list, quantities, Domain::open(), {.threads = 1});
    write(task, settings.count, list.size(), settings.repetitions,
          [&] { measurer.measure(list, geometry.spans()); });
  };
  row("gap", Quantity::gap);
  row("distance", Quantity::distance);
  row("vector", Quantity::vector);
  row("normal", Quantity::normal);
  row("point", Quantity::point);
  row("gap; normal; point", Quantity::gap | Quantity::normal | Quantity::point);
  measure_calls(elements, list, settings.repetitions);
}

/// A floor of hills and a field of boxes, with spheres that rest on both.
struct Walls {
  std::vector<std::array<double, 3>> corners, centers;
  std::vector<std::array<int, 3>> triangles;
  std::array<std::vector<double>, 3> lower, upper;
};

/// A hill and a box for each sphere, more or less; all spheres `away` along x.
Walls walls_for(std::size_t count, double away) {
  Walls walls;
  scenes::Random random(1);
  const int side = std::max(2, static_cast<int>(std::sqrt(static_cast<double>(count))));
  for (int k = 0; k < side * side; ++k) {
    const double x = k % side, y = k / side;
    walls.corners.push_back({x, y, random.uniform(0.0, 0.5)});
    walls.centers.push_back(
        {x + random.uniform(0.0, 1.0) + away, y + random.uniform(0.0, 1.0), 0.7});
    const double from[] = {x, y, 0.0}, to[] = {x + 0.5, y + 0.5, 0.4};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      walls.lower[axis].push_back(from[axis]);
      walls.upper[axis].push_back(to[axis]);
    }
    if (k % side == side - 1 || k / side == side - 1) continue;
    walls.triangles.push_back({k, k + 1, k + side + 1});
    walls.triangles.push_back({k, k + side + 1, k + side});
  }
  return walls;
}

/// Contacts with walls, and those with images of walls.
void measure_walls(const Settings& settings, bool with_images) {
  const std::size_t count = std::min<std::size_t>(settings.count, 100'000);
  const double side = std::floor(std::sqrt(static_cast<double>(count))) + 3.0;
  const Walls walls = walls_for(count, with_images ? side : 0.0);
  const Domain domain =
      with_images ? Domain::periodic({side, unbounded, unbounded}) : Domain::open();
  const std::string with = with_images ? "images of " : "";
  const ElementView elements = spheres(walls.centers, 0.5);
  const Quantities quantities = Quantity::gap | Quantity::normal | Quantity::point;
  const auto row = [&](const std::string& task, const auto& wall, const auto& list) {
    PairGeometry geometry = measure(elements, wall, list, quantities, domain, {.threads = 1});
    write(task, elements.size(), list.size(), settings.repetitions,
          [&] { measure(elements, wall, list, geometry.spans(), domain, {.threads = 1}); });
  };
  const Options options{.shifts = Shifts::stored, .threads = 1};
  const TriangleMesh mesh(walls.corners, walls.triangles);
  row("gap; normal; point of " + with + "a mesh", mesh,
      find_mesh_contacts(elements, mesh, domain, options));
  const ElementView solids = boxes(walls.lower[0], walls.lower[1], walls.lower[2], walls.upper[0],
                                   walls.upper[1], walls.upper[2]);
  row("gap; normal; point of " + with + "boxes", solids,
      find_box_contacts(elements, solids, domain, options));
}

/// So few elements that their numbers stay in the cache.
void measure_few(const Settings& settings) {
  const std::size_t count = std::min<std::size_t>(settings.count, 3000);
  const scenes::Scene scene = scenes::scene_named(settings.scene).make(count, 1);
  const ElementView elements = spheres(scene.x, scene.y, scene.z, scene.radius);
  measure_calls(elements, find_contact_pairs(elements, Domain::open(), {.threads = 1}),
                settings.repetitions);
}

/// Whether candidates still serve, of elements that did not move.
void measure_needs_rebuild(const Settings& settings, std::size_t count) {
  const scenes::Scene scene = scenes::scene_named(settings.scene).make(count, 1);
  const ElementView elements = spheres(scene.x, scene.y, scene.z, scene.radius);
  CandidateList candidates(0.1, NeighborListKind::half, {.threads = 1});
  candidates.rebuild(elements);
  bool needed = false;
  write("needs_rebuild() an element", count, count, settings.repetitions,
        [&] { needed = needed || candidates.needs_rebuild(elements); });
  if (needed) std::puts("elements that stand still have moved");
}

/// Points at random, 40 of each one's within the cutoff, each pair once.
void measure_liquid(const Settings& settings) {
  constexpr double neighbors_of_each = 40.0;
  const double side = std::cbrt(static_cast<double>(settings.atoms));
  const double cutoff = std::cbrt(2.0 * neighbors_of_each / (4.0 / 3.0 * std::acos(-1.0)));
  scenes::Random random(1);
  std::vector<double> x, y, z;
  for (std::size_t k = 0; k < settings.atoms; ++k) {
    x.push_back(random.uniform(0.0, side));
    y.push_back(random.uniform(0.0, side));
    z.push_back(random.uniform(0.0, side));
  }
  const Domain cube = Domain::periodic({side, side, side});
  const auto list = [&](Shifts shifts, Quantities quantities) {
    return neighbors(points(x, y, z), cutoff, cube, NeighborListKind::half,
                     {.shifts = shifts, .quantities = quantities, .threads = 1});
  };
  const std::size_t entries = list(Shifts::none, {}).neighbors().size();
  write("liquid: neighbors", settings.atoms, entries, settings.repetitions,
        [&] { static_cast<void>(list(Shifts::none, {})); });
  write("liquid: shifts too", settings.atoms, entries, settings.repetitions,
        [&] { static_cast<void>(list(Shifts::stored, {})); });
  write("liquid: distances and vectors too", settings.atoms, entries, settings.repetitions,
        [&] { static_cast<void>(list(Shifts::stored, Quantity::distance | Quantity::vector)); });
  const std::vector<double> radii(settings.atoms, 0.0);
  Detector detector({.shifts = Shifts::stored,
                     .quantities = Quantity::distance | Quantity::vector,
                     .margin = cutoff,
                     .threads = 1});
  write("liquid: all of it by a Detector", settings.atoms, entries, settings.repetitions, [&] {
    detector.build_neighbor_list(spheres(x, y, z, radii), cube, NeighborListKind::half);
  });
}

int main_of(int argc, char** argv) {
  CommandLine command_line("Times the geometry of contacts; CSV on stdout.");
  Settings settings;
  command_line.add("--scene", settings.scene, "of spheres");
  command_line.add("--count", settings.count, "elements", {2.0, 100'000'000.0});
  command_line.add("--atoms", settings.atoms, "points of the liquid", {100.0, 10'000'000.0});
  command_line.add("--repetitions", settings.repetitions, "after one that is not counted",
                   {1.0, 10'000.0});
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;
  std::puts("task,elements,entries,ns_minimum,ns_median");
  measure_scene(settings);
  measure_few(settings);
  measure_walls(settings, false);
  measure_walls(settings, true);
  measure_needs_rebuild(settings, std::min<std::size_t>(settings.count, 10'000));
  measure_needs_rebuild(settings, settings.count);
  measure_liquid(settings);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("pair_geometry", abut::benchmarks::main_of, argc, argv);
}
