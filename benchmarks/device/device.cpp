// Times abut::device beside ceilings of the device, the processor and a plain grid, part by part.
// benchmarks/device/run runs it. Exit code 6 without a device, 7 where an answer of abut is wrong.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/device/ceilings.hpp"
#include "benchmarks/device/cuda_calls.hpp"
#include "benchmarks/device/device_case.hpp"
#include "benchmarks/device/device_forms.hpp"

#include <abut/device.hpp>
#include <abut/version.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

/// The scenes of the matrix, dense and thin, of equal sizes and not.
constexpr const char* scenes_of_matrix[] = {"dense",
                                            "dense_spread",
                                            "ordered",
                                            "gas",
                                            "sph",
                                            "sparse",
                                            "clusters",
                                            "crowds",
                                            "bidisperse",
                                            "polydisperse",
                                            "log_uniform",
                                            "log_uniform_1000",
                                            "graded",
                                            "graded_1000",
                                            "one_giant",
                                            "touching_cubic",
                                            "touching_fcc",
                                            "touching_fcc_shuffled",
                                            "two_far_clusters",
                                            "hexagonal_2d",
                                            "gas_2d"};

/// The dense packing has 3 pairs an element, and with this margin about 21.
constexpr double margin_of_21_pairs = 2.31;

/// What the table was measured with.
void print_versions() {
  int driver = 0;
  require(cudaDriverGetVersion(&driver), "tell its driver");
  const device::DeviceInfo device = device::devices().front();
  std::printf("# device: %s, %.1f GiB\n", device.name.c_str(),
              static_cast<double>(device.memory_bytes) / 1073741824.0);
  std::printf("# CUDA: driver %d.%d, runtime %d.%d\n", driver / 1000, driver % 1000 / 10,
              CUDART_VERSION / 1000, CUDART_VERSION % 1000 / 10);
  std::printf("# abut: %s\n", std::string(build_description()).c_str());
}

void print_ceilings(const std::vector<Ceiling>& ceilings) {
  for (const Ceiling& ceiling : ceilings) {
    const auto n = static_cast<double>(ceiling.items);
    std::printf("%s,%llu,%.4f,%.5f,%.3f,%.3e\n", ceiling.name.c_str(),
                static_cast<unsigned long long>(ceiling.items), 1e3 * ceiling.seconds,
                1e9 * ceiling.seconds / n, 1e-9 * n / ceiling.seconds,
                n * ceiling.bytes_of_item / ceiling.seconds);
  }
  std::fflush(stdout);
}

bool run_ceilings(std::initializer_list<std::uint64_t> sizes) {
  std::puts("ceiling,items,ms,ns_per_item,billions_per_second,bytes_per_second");
  print_ceilings(measure_latencies());
  for (const std::uint64_t items : sizes) print_ceilings(measure_ceilings(items));
  return true;
}

DeviceEffort effort_of(int calls) {
  const DeviceEffort effort{calls, copy_speed()};
  std::printf("# copy: %.3e bytes a second\n", effort.copy_speed);
  std::puts(
      "# of_moved_bytes: the time by that of a copy of the bytes that the stages move at least;"
      " not told where ghosts or levels of sizes are not known");
  print_heading();
  return effort;
}

/// Measures scenes one after the other by `measure`.
template <class Cases, class Measure>
bool run_cases(const Cases& cases, const DeviceEffort& effort, const Measure& measure) {
  bool all_right = true;
  for (const SceneCase& what : cases) all_right &= measure(what, effort);
  return all_right;
}

/// Scenes of several sizes.
template <class Names>
std::vector<SceneCase> cases_of(const Names& names, std::initializer_list<std::uint64_t> sizes) {
  std::vector<SceneCase> cases;
  for (const std::uint64_t elements : sizes) {
    for (const char* const name : names) cases.push_back({name, elements});
  }
  return cases;
}

bool run_part(int part) {
  constexpr std::array some = {"dense", "ordered", "gas", "graded_1000", "touching_fcc_shuffled"};
  constexpr std::array of_forms = {"dense", "gas", "graded_1000"};
  constexpr std::uint64_t large = 100'000'000;
  constexpr SceneCase large_cases[] = {
      {"dense", large}, {"dense", large, margin_of_21_pairs}, {"touching_fcc_shuffled", large}};
  std::vector<SceneCase> cases;
  switch (part) {
    case 1:
      return run_ceilings({1'000'000, large});
    case 2:
      cases = cases_of(scenes_of_matrix, {100'000, 1'000'000});
      cases.push_back({"coincident", 20'000});  // all pairs are contacts
      return run_cases(cases, effort_of(7), measure_scene);
    case 3:
      return run_cases(cases_of(some, {10'000'000}), effort_of(7), measure_scene);
    case 4:
      return run_cases(large_cases, effort_of(7), measure_scene);
    case 5:
      return measure_copies({"dense", large, margin_of_21_pairs}, 10, effort_of(1));
    default:
      return run_cases(cases_of(of_forms, {1'000'000, 10'000'000}), effort_of(7),
                       [](const SceneCase& what, const DeviceEffort& effort) {
                         return measure_forms(what.scene, what.elements, effort);
                       });
  }
}

int run(int argc, char** argv) {
  CommandLine command_line("times abut::device");
  int part = 1;
  command_line.add(
      "--part", part,
      "1 ceilings, 2 all scenes of 10^5 and 10^6 elements, 3 some of 10^7, 4 dense and "
      "touching of 10^8, 5 dense of 10^9, 6 gaps, neighbor lists and periodic domains",
      {1.0, 6.0});
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;
  { const device::Detector needed; }
  print_versions();
  return run_part(part) ? EXIT_SUCCESS : different_answers;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("device", abut::benchmarks::run, argc, argv);
}
