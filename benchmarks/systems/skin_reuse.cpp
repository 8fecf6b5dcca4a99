// Times a call that reuses the candidate pairs of a skin, in nanoseconds of processor time an
// element: a detector that returns contact pairs, and beside it a program that loops over the same
// candidates itself. Elements numbered at random, and along space. CSV on stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/random.hpp"
#include "scenes/scene.hpp"

#include <abut/abut.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

struct Settings {
  std::vector<std::size_t> counts{100'000, 1'000'000};
  std::vector<std::string> orders{"shuffled", "along space"};
  double skin = 0.1;
  double speed = 1e-4;  ///< largest way of an element in a step, diameter 1
  int repetitions = 15;
  bool detector_alone = false;
};

ElementView view_of(const scenes::Scene& scene) {
  return spheres(scene.x, scene.y, scene.z, scene.radius);
}

scenes::Scene along_space(const scenes::Scene& scene) {
  scenes::Scene sorted;
  for (const ElementIndex k : spatial_order(view_of(scene))) {
    sorted.x.push_back(scene.x[k]);
    sorted.y.push_back(scene.y[k]);
    sorted.z.push_back(scene.z[k]);
    sorted.radius.push_back(scene.radius[k]);
  }
  return sorted;
}

/// Keeps the library's candidates and tests them in a plain loop, as a program without a detector
/// would. Has room for all of them.
class Hand {
 public:
  Hand(const scenes::Scene& scene, double skin)
      : candidates_(skin, NeighborListKind::half, {.threads = 1}) {
    candidates_.rebuild(view_of(scene));
    pairs_.resize(candidates_.rows().neighbors().size() + 1);
  }

  [[nodiscard]] std::size_t candidates() const { return pairs_.size() - 1; }
  [[nodiscard]] bool is_outdated(const scenes::Scene& scene) const {
    return candidates_.needs_rebuild(view_of(scene));
  }

  /// Writes each candidate, and the next one over it unless it is a pair.
  PairCount find(const scenes::Scene& scene) {
    const NeighborList& rows = candidates_.rows();
    std::size_t found = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (const ElementIndex j : rows[i]) {
        const double x = scene.x[i] - scene.x[j];
        const double y = scene.y[i] - scene.y[j];
        const double z = scene.z[i] - scene.z[j];
        const double reach = scene.radius[i] + scene.radius[j];
        pairs_[found] = {static_cast<ElementIndex>(i), j};
        found += x * x + y * y + z * z <= reach * reach ? 1 : 0;
      }
    }
    return found;
  }

 private:
  CandidateList candidates_;
  std::vector<ContactPair> pairs_;
};

/// One line of the table. Returns false where the two differ, or candidates did not last.
bool measure(const Settings& settings, const std::string& order, scenes::Scene scene) {
  Detector detector({.threads = 1});
  detector.set_skin(Skin::fixed(settings.skin));
  detector.find_contact_pairs(view_of(scene));
  Hand hand(scene, settings.skin);
  scenes::Random random(3);
  std::vector<double> reuse;
  std::vector<double> check;
  std::vector<double> loop;
  bool same = true;
  for (int k = -1; k < settings.repetitions; ++k) {
    for (double& x : scene.x) x += random.uniform(-settings.speed, settings.speed);
    PairCount pairs = 0;
    reuse.push_back(
        processor_seconds([&] { pairs = detector.find_contact_pairs(view_of(scene)).size(); }));
    if (settings.detector_alone) continue;
    check.push_back(processor_seconds([&] { same = same && !hand.is_outdated(scene); }));
    loop.push_back(processor_seconds([&] { same = same && hand.find(scene) == pairs; }));
    if (k < 0) reuse.clear(), check.clear(), loop.clear();
  }
  const auto count = static_cast<double>(scene.size());
  const auto ns = [&](const std::vector<double>& seconds) {
    return seconds.empty() ? 0.0 : 1e9 * median(seconds) / count;
  };
  const SkinStatistics& found = detector.skin_statistics();
  std::printf("%s,%zu,%.3f,%.3f,%.2f,%.2f,%.2f\n", order.c_str(), scene.size(),
              static_cast<double>(found.candidates) / count,
              static_cast<double>(found.survivors) / count, ns(reuse), ns(check), ns(loop));
  std::fflush(stdout);
  return same && found.detections == 1 && found.candidates == hand.candidates();
}

int main_of(int argc, char** argv) {
  CommandLine command_line("Times the reuse of candidate pairs; CSV on stdout.");
  Settings settings;
  command_line.add("--counts", settings.counts, "elements of the dense scene");
  command_line.add_words("--orders", settings.orders, "of their numbers",
                         {"shuffled", "along space"});
  command_line.add("--skin", settings.skin, "in diameters");
  command_line.add("--speed", settings.speed, "largest way of an element in a step, in diameters");
  command_line.add("--repetitions", settings.repetitions, "after one that is not counted",
                   {1.0, 10'000.0});
  command_line.add_flag("--detector-alone", settings.detector_alone,
                        "nothing beside it, for profilers");
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  std::puts("order,elements,candidates,contacts,reuse_ns,check_ns,loop_ns");
  bool same = true;
  for (const std::size_t count : settings.counts) {
    const scenes::Scene scene = scenes::scene_named("dense").make(count, 1);
    for (const std::string& order : settings.orders) {
      same = measure(settings, order, order == "shuffled" ? scene : along_space(scene)) && same;
    }
  }
  if (same) return EXIT_SUCCESS;
  std::fprintf(stderr, "skin_reuse: other pairs than by hand, or candidates that did not last\n");
  return different_answers;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("skin_reuse", abut::benchmarks::main_of, argc, argv);
}
