// What threads cost and bring: a detection with some threads beside one with a single thread, from
// systems so small that waking a thread takes longer than searching to large ones; before them the
// first detection of a thread of the caller's, which starts its helpers. Prints CSV.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

namespace abut::benchmarks {
namespace {

struct Settings {
  std::vector<std::size_t> counts{500, 2000, 10'000, 100'000, 1'000'000};
  std::vector<int> threads{1, 2};
  std::string scene = "dense";
  int repetitions = 15;
};

template <class Work>
[[nodiscard]] double seconds(Work&& work) {
  Stopwatch stopwatch;
  work();
  return stopwatch.lap();
}

[[nodiscard]] ElementView view_of(const scenes::Scene& scene) {
  return scene.dimensions == 2 ? discs(scene.x, scene.y, scene.radius)
                               : spheres(scene.x, scene.y, scene.z, scene.radius);
}

/// Detections of a Detector that has warmed up, enough of them for a clock.
class Contestant {
 public:
  Contestant(const scenes::Scene& scene, int threads)
      : elements_(view_of(scene)),
        detector_({.threads = threads}),
        calls_(std::max<std::size_t>(200'000 / std::max<std::size_t>(scene.size(), 1), 1)) {
    detector_.find_contact_pairs(elements_);
  }

  void measure() {
    times_.push_back(seconds([&] {
                       for (std::size_t k = 0; k < calls_; ++k) {
                         pairs_ = detector_.find_contact_pairs(elements_).size();
                       }
                     }) /
                     static_cast<double>(calls_));
  }

  [[nodiscard]] PairCount pairs() const { return pairs_; }
  [[nodiscard]] double microseconds() const { return 1e6 * median(times_); }
  [[nodiscard]] double best() const {
    return 1e6 * *std::min_element(times_.begin(), times_.end());
  }

 private:
  ElementView elements_;
  Detector detector_;
  std::size_t calls_;
  std::vector<double> times_;
  PairCount pairs_ = 0;
};

/// The first detection of a thread; the elements are so few that nothing else takes long.
void measure_start(const Settings& settings) {
  const scenes::Scene scene = scenes::scene_named(settings.scene).make(500, 1);
  for (const int threads : settings.threads) {
    std::vector<double> times;
    for (int k = 0; k < settings.repetitions; ++k) {
      std::thread([&] {
        times.push_back(seconds([&] {
          static_cast<void>(
              count_contact_pairs(view_of(scene), Domain::open(), {.threads = threads}));
        }));
      }).join();
    }
    std::printf("first call,%zu,%d,%.2f,%.2f,\n", scene.size(), threads, 1e6 * median(times),
                1e6 * *std::min_element(times.begin(), times.end()));
  }
}

/// The contestants take turns, so that what else happens on the machine falls on all. Whether all
/// found the same number of pairs.
bool measure_count(const Settings& settings, std::size_t count) {
  const scenes::Scene scene = scenes::scene_named(settings.scene).make(count, 1);
  std::vector<Contestant> contestants;
  for (const int threads : settings.threads) contestants.emplace_back(scene, threads);
  for (int k = 0; k < settings.repetitions; ++k) {
    for (Contestant& contestant : contestants) contestant.measure();
  }
  bool same = true;
  for (std::size_t k = 0; k < contestants.size(); ++k) {
    const Contestant& contestant = contestants[k];
    std::printf("detection,%zu,%d,%.2f,%.2f,%.3f\n", scene.size(), settings.threads[k],
                contestant.microseconds(), contestant.best(),
                contestants.front().microseconds() / contestant.microseconds());
    same = same && contestant.pairs() == contestants.front().pairs();
  }
  std::fflush(stdout);
  return same;
}

int main_of(int argc, char** argv) {
  Settings settings;
  CommandLine command_line("What threads cost and bring");
  command_line.add("--counts", settings.counts, "elements");
  command_line.add("--threads", settings.threads, "threads; the first is compared with");
  command_line.add("--scene", settings.scene, "a scene");
  command_line.add("--repetitions", settings.repetitions, "of each", positive);
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  std::printf("what,elements,threads,microseconds,least_microseconds,times_faster\n");
  measure_start(settings);
  bool same = true;
  for (const std::size_t count : settings.counts) same = measure_count(settings, count) && same;
  if (!same) std::fprintf(stderr, "thread_costs: threads changed the number of pairs\n");
  return same ? EXIT_SUCCESS : different_answers;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("thread_costs", abut::benchmarks::main_of, argc, argv);
}
