// Times small sets, many different ones by turns: a processor learns by heart where the branches of
// one small set lead, so that a loop over the same one tells little
// (docs/adr/0036-few-elements-in-a-plane.md). CSV on stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

const std::vector<std::string> scene_names{"dense",        "gas",           "sparse",
                                           "bidisperse",   "log_uniform",   "clusters_100",
                                           "hexagonal_2d", "touching_cubic"};

struct Choice {
  std::vector<std::string> scenes = scene_names;
  std::vector<std::size_t> counts{10, 20, 64, 100, 300, 1000, 3000, 8000};
  std::size_t elements = 200'000;
  int repetitions = 5;
};

ElementView view_of(const Scene& scene) {
  return scene.dimensions == 2 ? discs(scene.x, scene.y, scene.radius)
                               : spheres(scene.x, scene.y, scene.z, scene.radius);
}

/// A cell that the scene fills, with room for the widest element at its faces.
Domain cell_around(const Scene& scene) {
  const double widest = 2.0 * *std::max_element(scene.radius.begin(), scene.radius.end());
  const auto side = [&](const std::vector<double>& column) {
    const auto [least, most] = std::minmax_element(column.begin(), column.end());
    return *most - *least + widest;
  };
  if (scene.dimensions == 2) return Domain::periodic({side(scene.x), side(scene.y)});
  return Domain::periodic({side(scene.x), side(scene.y), side(scene.z)});
}

/// Seconds for one detection in each set, one after the other.
double seconds_of(const std::vector<Scene>& sets, const std::vector<Domain>& domains,
                  Detector& detector, std::uint64_t& pairs) {
  return processor_seconds([&] {
    pairs = 0;
    for (std::size_t k = 0; k < sets.size(); ++k) {
      pairs += detector.find_contact_pairs(view_of(sets[k]), domains[k]).size();
    }
  });
}

void measure(const std::string& name, std::size_t count, bool is_periodic, const Choice& choice) {
  std::vector<Scene> sets;
  std::vector<Domain> domains;
  while (sets.size() * count < choice.elements || sets.empty()) {
    sets.push_back(scenes::scene_named(name).make(count, sets.size() + 1));
    domains.push_back(is_periodic ? cell_around(sets.back()) : Domain::open());
  }
  const auto elements = static_cast<double>(sets.size() * count);
  std::printf("%s,%s,%zu,%zu", name.c_str(), is_periodic ? "periodic" : "open", count, sets.size());
  std::uint64_t pairs = 0;
  for (const Algorithm algorithm :
       {Algorithm::automatic, Algorithm::rows, Algorithm::direct_check}) {
    // Direct check of many takes long, and is never chosen.
    if (algorithm == Algorithm::direct_check && count > 300) {
      std::printf(",");
      continue;
    }
    Detector detector({.algorithm = algorithm, .order = Order::as_found, .threads = 1});
    std::vector<double> seconds;
    seconds_of(sets, domains, detector, pairs);
    for (int k = 0; k < choice.repetitions; ++k) {
      seconds.push_back(seconds_of(sets, domains, detector, pairs));
    }
    std::printf(",%.1f", median_and_minimum(seconds).median * 1e9 / elements);
  }
  std::printf(",%.2f\n", static_cast<double>(pairs) / elements);
}

int main_of(int argc, char** argv) {
  Choice choice;
  CommandLine command_line("Times detections in many small sets, as found, one thread.");
  command_line.add_words("--scenes", choice.scenes, "scenes to measure", scene_names);
  command_line.add("--counts", choice.counts, "elements of a set", {1.0, 1'000'000.0});
  command_line.add("--elements", choice.elements, "elements of all sets", {1.0, 100'000'000.0});
  command_line.add("--repetitions", choice.repetitions, "rounds", positive);
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;
  std::puts("scene,domain,elements,sets,auto_ns,rows_ns,direct_check_ns,pairs_an_element");
  for (const std::string& name : choice.scenes) {
    for (const bool is_periodic : {false, true}) {
      for (const std::size_t count : choice.counts) measure(name, count, is_periodic, choice);
    }
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("small_sets", abut::benchmarks::main_of, argc, argv);
}
