// Boxes that touch: `rows` beside libraries that find intersecting boxes, by turns, each answer
// compared with that of `rows` before anything is timed. CSV on stdout; exit code 7 for a
// difference.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "benchmarks/systems/box_contestant.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

namespace abut::benchmarks {
namespace {

ElementView view(const scenes::BoxScene& scene) {
  const auto& [lower, upper] = std::tie(scene.lower, scene.upper);
  return scene.dimensions == 2 ? rectangles(lower[0], lower[1], upper[0], upper[1])
                               : boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
}

class Abut {
 public:
  Abut() : detector_(options()) {}

  std::size_t run(const scenes::BoxScene& scene) {
    return detector_.find_contact_pairs(view(scene)).size();
  }

  static std::vector<ContactPair> sorted_pairs(const scenes::BoxScene& scene) {
    const PairList list = find_contact_pairs(view(scene));
    return {list.begin(), list.end()};
  }

 private:
  static Options options() {
    Options options;
    options.threads = 1;
    options.order = Order::as_found;
    return options;
  }

  Detector detector_;
};

/// Whether all agree.
bool measure(const std::string& name, std::size_t count, int repetitions) {
  const scenes::BoxScene scene = scenes::boxes_in(scenes::scene_named(name).make(count, 1), 2);
  const std::vector<ContactPair> expected = Abut::sorted_pairs(scene);
  std::vector<BoxContestant> contestants = enter_cgal_boxes();
  for (BoxContestant& bullet : enter_bullet_boxes()) contestants.push_back(std::move(bullet));
  bool agree = true;
  for (const BoxContestant& contestant : contestants) {
    std::vector<ContactPair> found = contestant.run(scene);
    std::sort(found.begin(), found.end());
    if (found == expected) continue;
    agree = false;
    std::fprintf(stderr, "%s, %s, %zu: %zu pairs instead of %zu, or others\n", name.c_str(),
                 contestant.name.c_str(), count, found.size(), expected.size());
  }

  Abut abut;
  abut.run(scene);
  std::vector<double> own;
  std::vector<std::vector<double>> theirs(contestants.size());
  for (int k = 0; k < repetitions; ++k) {
    own.push_back(processor_seconds([&] { abut.run(scene); }));
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      theirs[c].push_back(processor_seconds([&] { contestants[c].run(scene); }));
    }
  }
  const double ns = 1e9 / static_cast<double>(std::max<std::size_t>(1, count));
  const auto write = [&](const std::string& who, double seconds) {
    std::printf("%s,%zu,%zu,%s,%.1f,%.2f\n", name.c_str(), count, expected.size(), who.c_str(),
                seconds * ns, seconds / median(own));
  };
  write("abut", median(own));
  for (std::size_t c = 0; c < contestants.size(); ++c) {
    write(contestants[c].name, median(theirs[c]));
  }
  return agree;
}

int main_of(int argc, char** argv) {
  CommandLine command_line("Times `rows` on boxes beside CGAL and Bullet; CSV on stdout.");
  std::vector<std::string> names{"dense", "sparse", "log_uniform_1000", "hexagonal_2d", "gas_2d"};
  std::vector<std::size_t> counts{100'000, 1'000'000};
  int repetitions = 5;
  command_line.add("--scenes", names, "boxes lie in their elements");
  command_line.add("--counts", counts, "elements");
  command_line.add("--repetitions", repetitions, "medians of so many", {1.0, 1000.0});
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  std::puts("scene,elements,contact_pairs,contestant,ns,times_abut");
  bool agree = true;
  for (const std::string& name : names) {
    for (const std::size_t count : counts) agree = measure(name, count, repetitions) && agree;
  }
  return agree ? EXIT_SUCCESS : different_answers;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("box_contacts", abut::benchmarks::main_of, argc, argv);
}
