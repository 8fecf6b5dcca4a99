// Times `rows` where density spans decades, and says how much memory it takes: crowds within
// crowds, as deep as numbers allow (docs/adr/0034-sets-that-wait.md). CSV on stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/many_scales.hpp"

#include <abut/abut.hpp>

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Radii;

struct Choice {
  std::vector<std::size_t> counts{3000, 30000, 100000};
  std::vector<double> decades{6, 12, 50, 250};
  int threads = 1;
  int repetitions = 5;
};

void measure(Radii radii, double decades, std::size_t count, const Choice& choice) {
  constexpr std::array<const char*, 3> names{"equal", "as root", "as distance"};
  const scenes::Scene scene = scenes::spheres_of_scales({.radii = radii}, decades, count);
  const ElementView elements = spheres(scene.x, scene.y, scene.z, scene.radius);
  std::vector<double> seconds;
  Statistics statistics;
  for (int k = 0; k < choice.repetitions; ++k) {
    seconds.push_back(processor_seconds([&] {
      statistics = count_contact_pairs(elements, Domain::open(),
                                       {.algorithm = Algorithm::rows, .threads = choice.threads});
    }));
  }
  const auto elements_of = static_cast<double>(count);
  std::printf("%s,%g,%zu,%llu,%.1f,%.1f,%.0f\n", names[static_cast<std::size_t>(radii)], decades,
              count, static_cast<unsigned long long>(statistics.contact_pairs),
              median_and_minimum(seconds).median * 1e9 / elements_of,
              static_cast<double>(statistics.candidate_tests) / elements_of,
              static_cast<double>(statistics.working_bytes) / elements_of);
}

int main_of(int argc, char** argv) {
  Choice choice;
  CommandLine command_line(
      "Times rows where density spans decades, and says how much memory it takes.");
  command_line.add("--counts", choice.counts, "numbers of elements", {1.0, 100'000'000.0});
  command_line.add("--decades", choice.decades, "decades of distances from a point", {0.0, 300.0});
  command_line.add("--threads", choice.threads, "threads", {1.0, 1024.0});
  command_line.add("--repetitions", choice.repetitions, "detections", positive);
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;
  std::puts("radii,decades,elements,pairs,median_ns,tests,bytes");
  for (const Radii radii : {Radii::equal, Radii::as_root, Radii::as_distance}) {
    for (const double decades : choice.decades) {
      for (const std::size_t count : choice.counts) measure(radii, decades, count, choice);
    }
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("scales", abut::benchmarks::main_of, argc, argv);
}
