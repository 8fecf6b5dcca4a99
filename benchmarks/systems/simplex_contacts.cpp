// Triangles and tetrahedra that touch: abut beside CGAL, by turns, after both found the same pairs.
// CSV on stdout; exit code 7 for a difference.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "benchmarks/systems/simplex_contestant.hpp"
#include "scenes/random.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace abut::benchmarks {
namespace {

/// Of random shape, at random places, so close that each has some candidates.
template <std::size_t Corners>
SimplexScene<Corners> scene_of(std::size_t count) {
  scenes::Random random(1);
  SimplexScene<Corners> scene;
  const double side = std::cbrt(2.0 * static_cast<double>(count));
  for (std::size_t k = 0; k < count; ++k) {
    std::array<double, 3> center{};
    for (double& x : center) x = random.uniform(0.0, side);
    std::array<ElementIndex, Corners> cell{};
    for (ElementIndex& number : cell) {
      number = static_cast<ElementIndex>(scene.vertices.size());
      auto& vertex = scene.vertices.emplace_back(center);
      for (double& x : vertex) x += random.uniform(-1.0, 1.0);
    }
    scene.cells.push_back(cell);
  }
  return scene;
}

Options options() {
  Options options;
  options.threads = 1;
  options.order = Order::as_found;
  return options;
}

/// Whether both agree.
template <std::size_t Corners>
bool measure(const char* name, std::size_t count, int repetitions) {
  const SimplexScene<Corners> scene = scene_of<Corners>(count);
  const SimplexView view = simplices_3d(scene.vertices, scene.cells);
  const auto find_boxes = [&] {
    const FittedBoxes boxes = fit_boxes_3d(scene.vertices, scene.cells);
    return find_contact_pairs(boxes.view(), Domain::open(), options()).size();
  };
  CgalSimplices<Corners> cgal;
  const PairList expected = find_simplex_contacts(view);
  std::vector<ContactPair> found = cgal.run(scene);
  std::sort(found.begin(), found.end());
  const bool agree = std::equal(found.begin(), found.end(), expected.begin(), expected.end());
  if (!agree) {
    std::fprintf(stderr, "%s, %zu: %zu pairs instead of %llu, or others\n", name, count,
                 found.size(), static_cast<unsigned long long>(expected.size()));
  }

  std::vector<double> own, of_boxes, theirs;
  for (int k = 0; k < repetitions; ++k) {
    own.push_back(
        processor_seconds([&] { static_cast<void>(find_simplex_contacts(view, options())); }));
    of_boxes.push_back(processor_seconds([&] { static_cast<void>(find_boxes()); }));
    theirs.push_back(processor_seconds([&] { static_cast<void>(cgal.run(scene)); }));
  }
  const auto candidates = static_cast<unsigned long long>(find_boxes());
  const auto write = [&](const char* who, double seconds) {
    std::printf("%s,%zu,%llu,%zu,%s,%.1f,%.2f\n", name, count, candidates, found.size(), who,
                1e9 * seconds / static_cast<double>(std::max(1ULL, candidates)),
                seconds / median(own));
  };
  write("abut", median(own));
  write("boxes alone", median(of_boxes));
  write("cgal", median(theirs));
  return agree;
}

int main_of(int argc, char** argv) {
  CommandLine command_line(
      "Times contacts of triangles and tetrahedra beside CGAL; CSV on stdout.");
  std::size_t count = 200'000;
  int repetitions = 5;
  command_line.add("--count", count, "simplices");
  command_line.add("--repetitions", repetitions, "medians of so many", {1.0, 1000.0});
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  std::puts("case,elements,candidates,contact_pairs,contestant,ns,times_abut");
  const bool triangles = measure<3>("triangles", count, repetitions);
  const bool tetrahedra = measure<4>("tetrahedra", count, repetitions);
  return triangles && tetrahedra ? EXIT_SUCCESS : different_answers;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("simplex_contacts", abut::benchmarks::main_of, argc, argv);
}
