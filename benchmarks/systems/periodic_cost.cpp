// Times `rows` with the same elements in open space and in periodic cells of several kinds. The
// cases take turns, so that all meet the same machine. CSV on stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <list>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

using Vector = std::array<double, 3>;

struct Cell {
  Vector a, b, c;

  [[nodiscard]] Domain domain() const { return Domain::lattice(a, b, c); }
};

struct Case {
  std::string name;
  const scenes::Scene& scene;
  Domain domain;
  Shifts shifts = Shifts::none;
};

/// Case and Detector, with the seconds of processor time that each repetition took.
struct Run {
  explicit Run(const Case& which) : what(which), detector(options(which)) {}

  static Options options(const Case& which) {
    Options options;
    options.algorithm = Algorithm::rows;
    options.threads = 1;
    options.order = Order::as_found;
    options.shifts = which.shifts;
    return options;
  }

  void once() {
    const scenes::Scene& s = what.scene;
    seconds.push_back(processor_seconds([&] {
      pairs = detector.find_contact_pairs(spheres(s.x, s.y, s.z, s.radius), what.domain).size();
    }));
  }

  Case what;
  Detector detector;
  std::vector<double> seconds;
  PairCount pairs = 0;
};

/// The sides of the box, wide enough that elements at opposite faces do not overlap more than
/// neighbors do.
Vector sides_of(const scenes::Scene& scene) {
  const auto side = [&](const std::vector<double>& column) {
    const auto [lower, upper] = std::minmax_element(column.begin(), column.end());
    return *upper - *lower + scene.radius[0];
  };
  return {side(scene.x), side(scene.y), side(scene.z)};
}

/// The elements moved into a cell whose vectors are the rows of a lower triangular matrix, or, of
/// 2 layers + 1 cells along each vector, each element into another one.
scenes::Scene moved_into(const Cell& cell, scenes::Scene scene, std::size_t layers) {
  const std::array<const Vector*, 3> vectors{&cell.a, &cell.b, &cell.c};
  const std::array<std::vector<double>*, 3> columns{&scene.x, &scene.y, &scene.z};
  for (std::size_t k = 0; k < scene.x.size(); ++k) {
    Vector rest{scene.x[k], scene.y[k], scene.z[k]};
    for (std::size_t v = 3; v-- > 0;) {
      const double fraction = rest[v] / (*vectors[v])[v];
      const std::size_t layer = k * (v + 3) % (2 * layers + 1);
      const double cells =
          std::floor(fraction) + static_cast<double>(layer) - static_cast<double>(layers);
      for (std::size_t axis = 0; axis <= v; ++axis) {
        rest[axis] -= fraction * (*vectors[v])[axis];
        (*columns[axis])[k] -= cells * (*vectors[v])[axis];
      }
    }
  }
  return scene;
}

std::list<Case> cases_of(const std::list<scenes::Scene>& inputs, const Cell& block,
                         const Cell& tilted) {
  auto scene = inputs.begin();
  const scenes::Scene& given = *scene++;
  const scenes::Scene& inside = *scene++;
  const scenes::Scene& far = *scene++;
  std::list<Case> cases{{"open", given, Domain::open()},
                        {"open in the shape of the triclinic cell", inside, Domain::open()}};
  const auto add = [&](const std::string& name, const scenes::Scene& elements, const Cell& cell) {
    cases.push_back({name, elements, cell.domain()});
    cases.push_back({name + " with shifts", elements, cell.domain(), Shifts::stored});
  };
  add("block", given, block);
  add("block with elements in 27 cells", far, block);
  add("triclinic with elements inside", inside, tilted);
  add("triclinic with elements in a block", given, tilted);
  return cases;
}

void write(const Run& run, const Run& open, std::size_t elements) {
  const MedianAndMinimum own = median_and_minimum(run.seconds);
  const MedianAndMinimum base = median_and_minimum(open.seconds);
  const double ns = 1e9 / static_cast<double>(elements);
  std::printf("%s,%zu,%llu,%.2f,%.2f,%.3f,%.3f\n", run.what.name.c_str(), elements,
              static_cast<unsigned long long>(run.pairs), own.minimum * ns, own.median * ns,
              own.minimum / base.minimum, own.median / base.median);
}

int main_of(int argc, char** argv) {
  CommandLine command_line("Times `rows` in periodic cells against open space; CSV on stdout.");
  std::string name = "dense";
  std::size_t count = 1'000'000;
  int repetitions = 9;
  std::string only;
  command_line.add("--scene", name, "of equal spheres");
  command_line.add("--count", count, "elements", {1.0, 100'000'000.0});
  command_line.add("--repetitions", repetitions, "after one that is not counted", {1.0, 10'000.0});
  command_line.add("--only", only, "a single case beside open");
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  std::list<scenes::Scene> inputs{scenes::scene_named(name).make(count, 1)};
  const Vector side = sides_of(inputs.front());
  const Cell block{{side[0], 0.0, 0.0}, {0.0, side[1], 0.0}, {0.0, 0.0, side[2]}};
  const Cell tilted{
      {side[0], 0.0, 0.0}, {0.4 * side[0], side[1], 0.0}, {0.3 * side[0], 0.2 * side[1], side[2]}};
  inputs.push_back(moved_into(tilted, inputs.front(), 0));
  inputs.push_back(moved_into(block, inputs.front(), 1));

  std::list<Run> runs;
  for (const Case& one : cases_of(inputs, block, tilted)) {
    if (only.empty() || one.name == "open" || one.name == only) runs.emplace_back(one);
  }
  for (Run& run : runs) run.once();
  for (Run& run : runs) run.seconds.clear();
  for (int k = 0; k < repetitions; ++k) {
    for (Run& run : runs) run.once();
  }
  std::puts("case,elements,contact_pairs,ns_minimum,ns_median,minimum_to_open,median_to_open");
  for (const Run& run : runs) write(run, runs.front(), inputs.front().x.size());
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("periodic_cost", abut::benchmarks::main_of, argc, argv);
}
