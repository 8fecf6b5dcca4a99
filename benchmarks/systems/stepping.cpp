// Times the steps of a dense packing whose elements move: a detector that detects anew in each
// step, detectors with skins of several lengths and with an automatic one, and the history of
// contacts beside them. Each must find as many pairs in all steps as the first. CSV on stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/random.hpp"
#include "scenes/scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

struct Settings {
  std::size_t count = 1'000'000;
  int steps = 100;
  double speed = 0.002;  ///< largest way of an element in a step, diameter 1
  int threads = 1;
  bool periodic = false;
  std::string scene = "dense";
  std::size_t exchanged = 0;  ///< elements that are replaced by others in every tenth step
};

/// Elements that fly on, each in its direction.
class System {
 public:
  explicit System(const Settings& settings)
      : scene_(scenes::scene_named(settings.scene).make(settings.count, 1)) {
    scenes::Random random(3);
    for (auto& velocity : velocity_) {
      for (std::size_t k = 0; k < settings.count; ++k) {
        velocity.push_back(settings.speed * random.uniform(-1.0, 1.0));
      }
    }
    for (const double x : scene_.x) side_ = std::max(side_, x);
    if (settings.periodic) domain = Domain::periodic({side_, side_, side_});
    for (std::uint64_t k = 0; k < settings.count; ++k) ids.push_back(next_id_++);
  }

  /// Elements leave, and others appear elsewhere under their numbers.
  void exchange(std::size_t count) {
    for (; count > 0; --count) {
      const std::size_t k = random_.below(scene_.size());
      for (auto* axis : {&scene_.x, &scene_.y, &scene_.z}) (*axis)[k] = random_.uniform(0.0, side_);
      ids[k] = next_id_++;
    }
  }

  [[nodiscard]] ElementView elements() const {
    return spheres(scene_.x, scene_.y, scene_.z, scene_.radius);
  }

  void step() {
    const std::array<std::vector<double>*, 3> axes{&scene_.x, &scene_.y, &scene_.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < scene_.size(); ++k) (*axes[axis])[k] += velocity_[axis][k];
    }
  }

  Domain domain = Domain::open();
  std::vector<std::uint64_t> ids;

 private:
  scenes::Scene scene_;
  std::array<std::vector<double>, 3> velocity_;
  scenes::Random random_{5};
  double side_ = 1.0;
  std::uint64_t next_id_ = 0;
};

/// A tangential spring: three numbers.
struct Spring {
  std::array<double, 3> stretch{};
};

struct Measured {
  double detection = 0.0;  ///< seconds a step
  double history = 0.0;
  PairCount pairs = 0;
  SkinStatistics skin;
};

/// The first steps, in which memory grows, do not count.
Measured measure(const Settings& settings, Skin skin) {
  System system(settings);
  Options options;
  options.threads = settings.threads;
  if (settings.periodic) options.shifts = Shifts::stored;
  Detector detector(options);
  detector.set_skin(skin);
  ContactHistory<Spring> history(options);
  Measured result;
  const int warm_up = std::max(settings.steps / 10, 2);
  for (int step = -warm_up; step < settings.steps; ++step) {
    if (settings.exchanged > 0) {
      if (step % 10 == 0) system.exchange(settings.exchanged);
      detector.set_ids(system.ids);
    }
    Stopwatch stopwatch;
    const PairList& pairs = detector.find_contact_pairs(system.elements(), system.domain);
    const double detection = stopwatch.lap();
    const std::span<const std::uint64_t> ids(system.ids);
    history.update(pairs, system.elements(), system.domain,
                   settings.exchanged > 0 ? ids : ids.first(0));
    const double rest = stopwatch.lap();
    if (step >= 0) {
      result.detection += detection / settings.steps;
      result.history += rest / settings.steps;
      result.pairs += pairs.size();
    }
    system.step();
  }
  result.skin = detector.skin_statistics();
  return result;
}

void print(const Settings& settings, const char* name, const Measured& measured,
           const Measured& fresh) {
  const double scale = 1e9 / static_cast<double>(std::max<std::size_t>(settings.count, 1));
  std::printf("%s,%.3g,%.1f,%.2f,%.1f,%.2f,%llu,%llu,%llu\n", name, measured.skin.skin,
              measured.detection * scale, fresh.detection / measured.detection,
              measured.history * scale, measured.history / fresh.detection,
              static_cast<unsigned long long>(measured.skin.detections),
              static_cast<unsigned long long>(measured.skin.reuses),
              static_cast<unsigned long long>(measured.skin.candidates));
  std::fflush(stdout);
}

int main_of(int argc, char** argv) {
  Settings settings;
  CommandLine command_line("Stepping with and without a skin");
  command_line.add("--count", settings.count, "elements");
  command_line.add("--steps", settings.steps, "steps that are measured", positive);
  command_line.add("--speed", settings.speed, "way of an element in a step, in diameters");
  command_line.add("--threads", settings.threads, "threads");
  command_line.add("--scene", settings.scene, "a scene in 3D");
  command_line.add("--exchanged", settings.exchanged,
                   "elements that come and go in every tenth step");
  command_line.add_flag("--periodic", settings.periodic, "in a periodic box, with shifts");
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  std::printf(
      "skin,length,ns_per_element_and_step,times_faster,history_ns,history_share,"
      "detections,reuses,candidates\n");
  const Measured fresh = measure(settings, Skin::none());
  print(settings, "none", fresh, fresh);
  int different = 0;
  const auto compare = [&](const char* name, Skin skin) {
    const Measured measured = measure(settings, skin);
    print(settings, name, measured, fresh);
    different += measured.pairs == fresh.pairs ? 0 : 1;
  };
  for (const double length : {0.02, 0.05, 0.1, 0.2, 0.4}) compare("fixed", Skin::fixed(length));
  compare("automatic", Skin::automatic());
  if (different > 0) std::fprintf(stderr, "stepping: a skin changed the number of pairs\n");
  return different > 0 ? different_answers : EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("stepping", abut::benchmarks::main_of, argc, argv);
}
