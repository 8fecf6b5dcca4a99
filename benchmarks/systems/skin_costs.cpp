// Times what a detector with a skin does, in nanoseconds of processor time an element: a detection
// that keeps candidates, and a call that tests them, beside the numbers of candidates and contacts.
// The automatic skin counts with such costs (src/skin/skin_choice.cpp). CSV on stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/random.hpp"
#include "scenes/scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

struct Settings {
  std::vector<std::size_t> counts{20'000, 300'000};
  int repetitions = 3;
};

struct System {
  std::string name;
  scenes::Scene scene;
  Domain domain = Domain::open();
  double margin = 0.0;
};

/// Each repetition moves all elements by more than the skin, so that candidates are found anew in
/// memory that is there.
void measure(System system, double skin, int repetitions) {
  scenes::Scene& scene = system.scene;
  const ElementView elements = spheres(scene.x, scene.y, scene.z, scene.radius);
  Options options;
  options.threads = 1;
  options.margin = system.margin;
  if (system.domain.is_periodic()) options.shifts = Shifts::stored;
  Detector detector(options);
  const auto call = [&] {
    static_cast<void>(
        detector.build_neighbor_list(elements, system.domain, NeighborListKind::half));
  };
  double detection = std::numeric_limits<double>::infinity();
  double reuse = detection;
  detector.set_skin(Skin::fixed(skin));
  call();
  for (int k = 0; k < repetitions; ++k) {
    for (double& x : scene.x) x += skin;
    detection = std::min(detection, processor_seconds(call));
    for (int n = 0; n < 3; ++n) reuse = std::min(reuse, processor_seconds(call));
  }
  const auto count = static_cast<double>(scene.size());
  const SkinStatistics& found = detector.skin_statistics();
  std::printf("%s,%zu,%g,%.3f,%.3f,%.1f,%.1f\n", system.name.c_str(), scene.size(), skin,
              static_cast<double>(found.candidates) / count,
              static_cast<double>(found.survivors) / count, 1e9 * detection / count,
              1e9 * reuse / count);
  std::fflush(stdout);
}

/// Points at random in a periodic cube, as many of each one's within 2.5 as of a liquid.
System liquid(std::size_t count) {
  const double side = std::cbrt(static_cast<double>(count) / 0.8442);
  System system{"liquid", {}, Domain::periodic({side, side, side}), 2.5};
  scenes::Random random(1);
  for (std::size_t k = 0; k < count; ++k) {
    system.scene.x.push_back(random.uniform(0.0, side));
    system.scene.y.push_back(random.uniform(0.0, side));
    system.scene.z.push_back(random.uniform(0.0, side));
    system.scene.radius.push_back(0.0);
  }
  return system;
}

int main_of(int argc, char** argv) {
  CommandLine command_line("Times detections and reuses with a skin; CSV on stdout.");
  Settings settings;
  command_line.add("--counts", settings.counts, "elements");
  command_line.add("--repetitions", settings.repetitions, "of which the fastest counts", positive);
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  std::puts("scene,elements,skin,candidates,contacts,detection_ns,reuse_ns");
  for (const std::size_t count : settings.counts) {
    for (const char* name : {"dense", "gas", "ordered", "clusters"}) {
      const System system{name, scenes::scene_named(name).make(count, 1)};
      for (const double skin : {0.02, 0.1, 0.3, 0.8}) measure(system, skin, settings.repetitions);
    }
    for (const double skin : {0.1, 0.3, 0.6}) measure(liquid(count), skin, settings.repetitions);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("skin_costs", abut::benchmarks::main_of, argc, argv);
}
