// A drum of triangles that turns around a dense packing: what its contacts, and a history of them,
// take of processor time beside the contacts of the spheres, in the same steps. Lists are compared
// with the free function's. CSV on stdout.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "scenes/random.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

namespace abut::benchmarks {
namespace {

struct Settings {
  std::size_t count = 1000000;
  std::size_t triangles = 10000;
  int steps = 25;
  double angle = 0.02;  ///< of a step
  int threads = 1;
  bool with_quantities = false;
};

struct Packing {
  std::vector<double> x, y, z, r;
};

/// Spheres of diameter 1.04 on a cubic lattice of unit cells, shaken, in a drum as long as it is
/// wide around the axis x.
Packing packing_in(double radius, scenes::Random& random) {
  Packing packing;
  const int half = static_cast<int>(radius);
  const auto shaken = [&](int cell) { return cell + 0.5 + random.uniform(-0.05, 0.05); };
  for (int i = -half; i < half; ++i) {
    for (int j = -half; j < half; ++j) {
      for (int k = -half; k < half; ++k) {
        const double y = shaken(j), z = shaken(k);
        if (std::hypot(y, z) > radius - 0.5) continue;
        packing.x.push_back(shaken(i));
        packing.y.push_back(y);
        packing.z.push_back(z);
        packing.r.push_back(0.52);
      }
    }
  }
  return packing;
}

/// A closed cylinder: quads of the side and of the rings of both ends, each cut into two triangles.
TriangleMesh drum_of(double radius, std::size_t triangles) {
  const int around = std::max(8, static_cast<int>(std::sqrt(static_cast<double>(triangles))));
  const int rings = std::max(1, around / 16);
  const int rows = std::max(1, around / 2 - 2 * rings);
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<int, 3>> faces;
  const auto add_circle = [&](double x, double width) {
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / around;
      vertices.push_back({x, width * std::cos(angle), width * std::sin(angle)});
    }
  };
  for (int k = 0; k <= rings; ++k) add_circle(-radius, radius * (k + 0.01) / (rings + 0.01));
  for (int k = 1; k <= rows; ++k) add_circle(-radius + 2.0 * radius * k / rows, radius);
  for (int k = rings - 1; k >= 0; --k) add_circle(radius, radius * (k + 0.01) / (rings + 0.01));
  const int circles = static_cast<int>(vertices.size()) / around;
  for (int circle = 0; circle + 1 < circles; ++circle) {
    for (int k = 0; k < around; ++k) {
      const int a = circle * around + k, b = circle * around + (k + 1) % around;
      faces.push_back({a, b, b + around});
      faces.push_back({a, b + around, a + around});
    }
  }
  return TriangleMesh(vertices, faces);
}

Motion turned_by(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{{1.0, 0.0, 0.0}, {0.0, c, -s}, {0.0, s, c}}}, {}};
}

bool are_same(const MeshContactList& a, const MeshContactList& b) {
  return std::ranges::equal(a.contacts(), b.contacts()) && std::ranges::equal(a.gaps(), b.gaps());
}

/// Seconds of processor time in each step.
struct Seconds {
  std::vector<double> pairs, walls, motion, history;
};

/// Prints a line for each task: how many it found, what a step of it took, and that to the contacts
/// of the spheres.
void print(std::size_t spheres, std::size_t triangles, std::size_t pairs, std::size_t contacts,
           const Seconds& seconds) {
  std::puts("spheres,triangles,task,found,ms_per_step,ratio");
  const auto line = [&](const char* task, std::size_t found, const std::vector<double>& taken) {
    std::printf("%zu,%zu,%s,%zu,%.3f,%.3f\n", spheres, triangles, task, found, 1e3 * median(taken),
                median(taken) / median(seconds.pairs));
  };
  line("contacts of the spheres", pairs, seconds.pairs);
  line("contacts with the drum", contacts, seconds.walls);
  line("motion of the drum", triangles, seconds.motion);
  line("history of the contacts with the drum", contacts, seconds.history);
}

int run(const Settings& settings) {
  scenes::Random random(1);
  const double radius =
      std::cbrt(static_cast<double>(settings.count) / (2.0 * std::numbers::pi)) + 0.5;
  Packing packing = packing_in(radius, random);
  const ElementView elements = spheres(packing.x, packing.y, packing.z, packing.r);
  TriangleMesh drum = drum_of(radius, settings.triangles);
  Options options{.threads = settings.threads};
  if (settings.with_quantities) options.quantities = Quantity::gap | Quantity::normal;
  Detector detector(options);
  MeshContactHistory<std::array<double, 3>> history;
  Seconds seconds;
  std::size_t pairs = 0, contacts = 0;
  for (int step = 0; step <= settings.steps; ++step) {
    for (double& x : packing.x) x += random.uniform(-1e-3, 1e-3);
    const double motion = processor_seconds([&] { drum.move(turned_by(settings.angle * step)); });
    const double sphere =
        processor_seconds([&] { pairs = detector.find_contact_pairs(elements).size(); });
    const MeshContactList* list = nullptr;
    const double wall =
        processor_seconds([&] { list = &detector.find_mesh_contacts(elements, drum); });
    const double carrying = processor_seconds([&] { history.update(*list, elements, drum); });
    contacts = list->size();
    if (step == 0 || step == settings.steps) {
      const bool same = are_same(detector.find_mesh_contacts(elements, drum),
                                 find_mesh_contacts(elements, drum, options));
      if (!same) return different_answers;
    }
    if (step == 0) continue;  // builds the grid
    seconds.motion.push_back(motion);
    seconds.pairs.push_back(sphere);
    seconds.walls.push_back(wall);
    seconds.history.push_back(carrying);
  }
  print(packing.x.size(), drum.size(), pairs, contacts, seconds);
  return EXIT_SUCCESS;
}

int body(int argc, char** argv) {
  Settings settings;
  CommandLine command_line(
      "Contacts of a drum that turns beside those of the spheres in it; CSV on stdout.");
  command_line.add("--count", settings.count, "spheres, about");
  command_line.add("--triangles", settings.triangles, "triangles, about");
  command_line.add("--steps", settings.steps, "steps that are timed", positive);
  command_line.add("--angle", settings.angle, "by which the drum turns in a step");
  command_line.add("--threads", settings.threads, "threads");
  command_line.add_flag("--quantities", settings.with_quantities, "measure gaps and normals, too");
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;
  return run(settings);
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("moving_walls", abut::benchmarks::body, argc, argv);
}
