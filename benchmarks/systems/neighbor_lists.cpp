// Neighbor lists as molecular dynamics builds them: pairs within the reach and a skin, beside the
// contact pairs alone. CSV on stdout. With --lammps the same elements are written as a data file of
// LAMMPS first, for lammps_neighbors.py.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

ElementView view(const scenes::Scene& scene) {
  return spheres(scene.x, scene.y, scene.z, scene.radius);
}

Options one_thread(double margin) {
  Options options;
  options.threads = 1;
  options.margin = margin;
  options.order = Order::as_found;
  return options;
}

/// A list to build. `run` returns how many neighbors or pairs it has.
struct Task {
  const char* name;
  std::function<std::size_t(Detector&, const ElementView&)> run;
};

std::vector<Task> tasks() {
  const auto list = [](NeighborListKind kind) {
    return [kind](Detector& detector, const ElementView& elements) {
      return detector.build_neighbor_list(elements, Domain::open(), kind).neighbors().size();
    };
  };
  return {{"contact pairs",
           [](Detector& detector, const ElementView& elements) {
             return detector.find_contact_pairs(elements).size();
           }},
          {"half list", list(NeighborListKind::half)},
          {"full list", list(NeighborListKind::full)}};
}

void measure(const scenes::Scene& scene, double skin, int repetitions) {
  const ElementView elements = view(scene);
  const std::vector<Task> all = tasks();
  std::vector<std::vector<double>> seconds(all.size());
  std::vector<std::size_t> found(all.size());
  std::vector<Detector> detectors;
  for (const Task& task : all) {
    detectors.emplace_back(one_thread(skin));
    task.run(detectors.back(), elements);
  }
  for (int k = 0; k < repetitions; ++k) {
    for (std::size_t t = 0; t < all.size(); ++t) {
      seconds[t].push_back(
          processor_seconds([&] { found[t] = all[t].run(detectors[t], elements); }));
    }
  }
  const double elements_or_one = static_cast<double>(std::max<std::size_t>(scene.size(), 1));
  for (std::size_t t = 0; t < all.size(); ++t) {
    std::printf("%zu,%g,%.17g,%s,%zu,%.1f\n", scene.size(), skin, 2.0 * scene.radius[0] + skin,
                all[t].name, found[t], median(seconds[t]) * 1e9 / elements_or_one);
  }
}

/// LAMMPS' read_data format, style atomic: one type of mass 1.
void write_data(const scenes::Scene& scene, const std::string& path) {
  std::ofstream out(path);
  out.precision(17);
  out << "Spheres of one radius\n\n" << scene.size() << " atoms\n1 atom types\n\n";
  const char* const axes = "xyz";
  const std::vector<double>* const columns[] = {&scene.x, &scene.y, &scene.z};
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(columns[axis]->begin(), columns[axis]->end());
    out << *low - 1.0 << ' ' << *high + 1.0 << ' ' << axes[axis] << "lo " << axes[axis] << "hi\n";
  }
  out << "\nMasses\n\n1 1.0\n\nAtoms # atomic\n\n";
  for (std::size_t k = 0; k < scene.size(); ++k) {
    out << k + 1 << " 1 " << scene.x[k] << ' ' << scene.y[k] << ' ' << scene.z[k] << '\n';
  }
  out.flush();
  if (!out) throw std::runtime_error("cannot write '" + path + "'");
}

int main_of(int argc, char** argv) {
  CommandLine command_line("Times neighbor lists; CSV on stdout.");
  std::size_t count = 1'000'000;
  int repetitions = 5;
  std::string name = "dense";
  std::string lammps;
  std::vector<double> skins{0.0, 0.1, 0.3};
  command_line.add("--scene", name, "of equal spheres in 3D");
  command_line.add("--count", count, "elements", {1.0, 100'000'000.0});
  command_line.add("--skins", skins, "margins");
  command_line.add("--repetitions", repetitions, "medians of so many", {1.0, 1000.0});
  command_line.add("--lammps", lammps, "data file to write");
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  const scenes::Scene scene = scenes::scene_named(name).make(count, 1);
  if (!lammps.empty()) write_data(scene, lammps);
  std::puts("elements,skin,cutoff,task,found,ns");
  for (const double skin : skins) measure(scene, skin, repetitions);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("neighbor_lists", abut::benchmarks::main_of, argc, argv);
}
