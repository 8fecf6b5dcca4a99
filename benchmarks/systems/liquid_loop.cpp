// Times whole steps of molecular dynamics on a Lennard-Jones liquid: list, distances, forces and
// motion. A loop that keeps abut's list at cutoff + skin and tests distances itself stands beside
// loops that ask a Detector in each step. CSV on stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/random.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abut::benchmarks {
namespace {

/// In units of the Lennard-Jones potential: near the triple point.
constexpr double density = 0.8442;
constexpr double temperature = 0.72;
constexpr double cutoff = 2.5;
constexpr double skin = 0.3;
constexpr double time_step = 0.005;

/// A liquid, and for how long it moves.
struct Size {
  int cells;  ///< of four atoms, along each axis
  int steps;
};
/// 10,976 and 1,000,188 atoms.
constexpr Size sizes[] = {{14, 300}, {63, 300}};

struct Settings {
  int cells = 0;
  int steps = 0;
  int threads = 1;
  bool shuffled = false;
};

/// Atoms on a face-centred cubic lattice, with velocities at random.
class Liquid {
 public:
  explicit Liquid(const Settings& settings)
      : side_(settings.cells * std::cbrt(4.0 / density)),
        domain(Domain::periodic({side_, side_, side_})) {
    const double cell = side_ / settings.cells;
    const double corners[4][3] = {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
    for (int c = 0; c < settings.cells * settings.cells * settings.cells; ++c) {
      const int n[3] = {c % settings.cells, c / settings.cells % settings.cells,
                        c / settings.cells / settings.cells};
      for (const auto& corner : corners) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          x[axis].push_back((n[axis] + corner[axis]) * cell);
        }
      }
    }
    scenes::Random random(7);
    if (settings.shuffled) shuffle(random);
    set_velocities(random);
    for (auto& along : force) along.assign(size(), 0.0);
  }

  [[nodiscard]] std::size_t size() const { return x[0].size(); }
  [[nodiscard]] ElementView elements() const { return points(x[0], x[1], x[2]); }
  [[nodiscard]] double side() const { return side_; }

  void clear_forces() {
    potential = 0.0;
    for (auto& along : force) std::fill(along.begin(), along.end(), 0.0);
  }

  /// Adds what atoms j and i do to each other; `d` leads from i to j.
  void add(std::size_t i, std::size_t j, const double (&d)[3], double square) {
    const double inverse = 1.0 / square;
    const double sixth = inverse * inverse * inverse;
    const double strength = 48.0 * inverse * sixth * (sixth - 0.5);
    potential += 4.0 * sixth * (sixth - 1.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      force[axis][i] -= strength * d[axis];
      force[axis][j] += strength * d[axis];
    }
  }

  void move() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < size(); ++k) {
        velocity_[axis][k] += time_step * force[axis][k];
        x[axis][k] += time_step * velocity_[axis][k];
      }
    }
  }

 private:
  void shuffle(scenes::Random& random) {
    for (std::size_t k = size(); k > 1; --k) {
      const std::size_t other = random.below(k);
      for (auto& along : x) std::swap(along[k - 1], along[other]);
    }
  }

  /// Uniform in a cube, which collisions soon change; without motion of the whole.
  void set_velocities(scenes::Random& random) {
    const double fastest = std::sqrt(3.0 * temperature);
    for (auto& along : velocity_) {
      double sum = 0.0;
      for (std::size_t k = 0; k < size(); ++k) {
        along.push_back(random.uniform(-fastest, fastest));
        sum += along.back();
      }
      for (double& v : along) v -= sum / static_cast<double>(size());
    }
  }

  double side_;

 public:
  Domain domain;
  std::array<std::vector<double>, 3> x;
  std::array<std::vector<double>, 3> force;
  double potential = 0.0;

 private:
  std::array<std::vector<double>, 3> velocity_;
};

Options options_of(const Settings& settings, Quantities quantities) {
  return {.shifts = Shifts::stored, .quantities = quantities, .threads = settings.threads};
}

/// Adds the forces of a list of candidates or neighbors; `limit` is the largest square that counts.
void add_forces(Liquid& liquid, const NeighborList& list, double limit) {
  const double side = liquid.side();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::span<const ElementIndex> row = list[i];
    const std::span<const ImageShift> shifts = list.shifts_of(i);
    const double here[3] = {liquid.x[0][i], liquid.x[1][i], liquid.x[2][i]};
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::size_t j = row[k];
      const double d[3] = {liquid.x[0][j] + side * shifts[k].x - here[0],
                           liquid.x[1][j] + side * shifts[k].y - here[1],
                           liquid.x[2][j] + side * shifts[k].z - here[2]};
      const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      if (square <= limit) liquid.add(i, j, d, square);
    }
  }
}

/// The same with vectors that were stored.
void add_forces_of_vectors(Liquid& liquid, const NeighborList& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::span<const ElementIndex> row = list[i];
    const std::span<const Vector> vectors = list.row(i, list.vectors());
    for (std::size_t k = 0; k < row.size(); ++k) {
      const double d[3] = {vectors[k][0], vectors[k][1], vectors[k][2]};
      liquid.add(i, row[k], d, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
  }
}

struct Measured {
  double seconds = 0.0;  ///< processor time of a step
  double energy = 0.0;   ///< potential energy of an atom in the last step
  std::uint64_t detections = 0;
};

/// Runs all steps; `add` adds the forces of one, after it has brought the list up to date.
Measured run(const Settings& settings, Liquid& liquid, const std::function<void()>& add) {
  Stopwatch stopwatch(CLOCK_PROCESS_CPUTIME_ID);
  for (int step = 0; step < settings.steps; ++step) {
    liquid.clear_forces();
    add();
    liquid.move();
  }
  return {stopwatch.lap() / settings.steps, liquid.potential / static_cast<double>(liquid.size()),
          0};
}

/// The list of abut at cutoff + skin, kept until an atom has moved by half of the skin.
Measured loop_by_hand(const Settings& settings) {
  Liquid liquid(settings);
  Detector detector(options_of(settings, {}));
  Options options = detector.options();
  options.margin = cutoff + skin;
  detector.set_options(options);
  std::array<std::vector<double>, 3> then;
  const NeighborList* list = nullptr;
  std::uint64_t detections = 0;
  const auto has_moved = [&] {
    for (std::size_t k = 0; k < liquid.size(); ++k) {
      double square = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double way = liquid.x[axis][k] - then[axis][k];
        square += way * way;
      }
      if (square > 0.25 * skin * skin) return true;
    }
    return false;
  };
  Measured result = run(settings, liquid, [&] {
    if (list == nullptr || has_moved()) {
      list =
          &detector.build_neighbor_list(liquid.elements(), liquid.domain, NeighborListKind::half);
      then = liquid.x;
      ++detections;
    }
    add_forces(liquid, *list, cutoff * cutoff);
  });
  result.detections = detections;
  return result;
}

/// The same with the library's own candidate list.
Measured loop_with_candidates(const Settings& settings) {
  Liquid liquid(settings);
  Options options = options_of(settings, {});
  options.margin = cutoff;
  CandidateList candidates(skin, NeighborListKind::half, options);
  Measured result = run(settings, liquid, [&] {
    if (candidates.needs_rebuild(liquid.elements())) {
      candidates.rebuild(liquid.elements(), liquid.domain);
    }
    add_forces(liquid, candidates.rows(), cutoff * cutoff);
  });
  result.detections = candidates.rebuilds();
  return result;
}

Measured loop_with_detector(const Settings& settings, Skin chosen, Quantities quantities) {
  Liquid liquid(settings);
  Options options = options_of(settings, quantities);
  options.margin = cutoff;
  Detector detector(options);
  detector.set_skin(chosen);
  Measured result = run(settings, liquid, [&] {
    const NeighborList& list =
        detector.build_neighbor_list(liquid.elements(), liquid.domain, NeighborListKind::half);
    if (quantities == Quantities()) {
      add_forces(liquid, list, HUGE_VAL);
    } else {
      add_forces_of_vectors(liquid, list);
    }
  });
  result.detections = detector.skin_statistics().detections;
  return result;
}

/// Vectors are measured batch by batch in a visitor, so that neither neighbors nor vectors are
/// stored.
Measured loop_with_visitor(const Settings& settings, Skin chosen) {
  Liquid liquid(settings);
  Options options = options_of(settings, {});
  options.margin = cutoff;
  options.threads = 1;  // the forces take one
  Detector detector(options);
  detector.set_skin(chosen);
  std::vector<Vector> vectors;
  Measured result = run(settings, liquid, [&] {
    const PairMeasurer measurer(liquid.elements(), liquid.domain, options);
    const auto add_batch = [&](std::span<const ContactPair> pairs,
                               std::span<const ImageShift> shifts, WorkerNumber) {
      vectors.resize(std::max(vectors.size(), pairs.size()));
      measurer.measure({pairs, shifts}, {.vectors = std::span(vectors).first(pairs.size())});
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const double d[3] = {vectors[k][0], vectors[k][1], vectors[k][2]};
        liquid.add(pairs[k].first, pairs[k].second, d, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      }
    };
    detector.for_each_shifted_batch(liquid.elements(), liquid.domain, add_batch);
  });
  result.detections = detector.skin_statistics().detections;
  return result;
}

/// Prints a line for each loop; returns how many have other forces than the one by hand.
int compare_loops(const Settings& settings) {
  const auto atoms = Liquid(settings).size();
  const Measured by_hand = loop_by_hand(settings);
  int different = 0;
  const auto print = [&](const char* name, const Measured& measured) {
    std::printf("%zu,%d,%s,%.3f,%.3f,%llu,%.12g\n", atoms, settings.steps, name,
                1e3 * measured.seconds, measured.seconds / by_hand.seconds,
                static_cast<unsigned long long>(measured.detections), measured.energy);
    std::fflush(stdout);
    // The sums of forces are of the same terms, rounded in other ways.
    different += std::fabs(measured.energy - by_hand.energy) <= 1e-6 ? 0 : 1;
  };
  print("list kept by hand", by_hand);
  print("candidate list", loop_with_candidates(settings));
  print("fixed skin", loop_with_detector(settings, Skin::fixed(skin), {}));
  print("automatic skin", loop_with_detector(settings, Skin::automatic(), {}));
  print("fixed skin and vectors",
        loop_with_detector(settings, Skin::fixed(skin), Quantity::vector));
  print("fixed skin and vectors in a visitor", loop_with_visitor(settings, Skin::fixed(skin)));
  print("no skin", loop_with_detector(settings, Skin::none(), {}));
  return different;
}

int main_of(int argc, char** argv) {
  CommandLine command_line("Times steps of a Lennard-Jones liquid; CSV on stdout.");
  Settings settings;
  command_line.add("--cells", settings.cells, "cells of four atoms along each axis", {5.0, 200.0});
  command_line.add("--steps", settings.steps, "steps", {1.0, 1'000'000.0});
  command_line.add("--threads", settings.threads, "threads of abut; the forces take one");
  command_line.add_flag("--shuffled", settings.shuffled, "numbers of atoms do not follow space");
  command_line.require_with("--steps", "--cells");
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  std::puts("atoms,steps,loop,ms_per_step,ratio,detections,energy");
  int different = 0;
  if (command_line.has("--cells")) {
    if (settings.steps == 0) settings.steps = sizes[0].steps;
    different = compare_loops(settings);
  } else {
    for (const auto& [along, steps] : sizes) {
      settings.cells = along;
      settings.steps = steps;
      different += compare_loops(settings);
    }
  }
  if (different > 0) std::fprintf(stderr, "liquid_loop: a loop has other forces\n");
  return different > 0 ? different_answers : EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("liquid_loop", abut::benchmarks::main_of, argc, argv);
}
