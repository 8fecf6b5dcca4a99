// One set against another: the search of two sets beside what it replaces, one search of both
// together whose pairs within a set are dropped, and beside CGAL, by turns. Answers are compared
// before anything is timed. CSV on stdout; exit code 7 for a difference.

#include "benchmarks/common/command_line.hpp"
#include "benchmarks/common/program.hpp"
#include "benchmarks/common/timing.hpp"
#include "benchmarks/systems/contestants/cgal_two_sets.hpp"
#include "benchmarks/systems/two_scenes.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

ElementView view(const scenes::Scene& scene) {
  return spheres(scene.x, scene.y, scene.z, scene.radius);
}

Options one_thread() {
  Options options;
  options.threads = 1;
  options.order = Order::as_found;
  return options;
}

class TwoSets {
 public:
  std::size_t run(const TwoScenes& sets) {
    return detector_.find_contact_pairs(view(sets.first), view(sets.second)).size();
  }

 private:
  Detector detector_{one_thread()};
};

/// Element j of the second set is number first.size() + j.
class OneSetFiltered {
 public:
  const std::vector<ContactPair>& run(const TwoScenes& sets) {
    const auto first = static_cast<ElementIndex>(sets.first.size());
    pairs_.clear();
    for (const ContactPair& pair : detector_.find_contact_pairs(view(sets.both))) {
      if (pair.first < first && pair.second >= first)
        pairs_.push_back({pair.first, pair.second - first});
    }
    return pairs_;
  }

 private:
  Detector detector_{one_thread()};
  std::vector<ContactPair> pairs_;
};

bool same(const char* who, const TwoScenes& sets, std::vector<ContactPair> found) {
  const PairList expected = find_contact_pairs(view(sets.first), view(sets.second));
  std::sort(found.begin(), found.end());
  if (std::equal(found.begin(), found.end(), expected.begin(), expected.end())) return true;
  std::fprintf(stderr, "%s, %s: %zu pairs instead of %zu, or others\n", sets.name.c_str(), who,
               found.size(), expected.size());
  return false;
}

/// Whether all agree.
bool measure(const TwoScenes& sets, int repetitions) {
  TwoSets two_sets;
  OneSetFiltered one_set;
  CgalOfTwoSets cgal;
  const std::size_t pairs = two_sets.run(sets);
  bool agree = same("one set", sets, one_set.run(sets));
  agree = same("cgal_box", sets, cgal.run(sets)) && agree;

  std::vector<double> own;
  std::vector<double> filtered;
  std::vector<double> theirs;
  for (int k = 0; k < repetitions; ++k) {
    own.push_back(processor_seconds([&] { two_sets.run(sets); }));
    filtered.push_back(processor_seconds([&] { one_set.run(sets); }));
    theirs.push_back(processor_seconds([&] { cgal.run(sets); }));
  }
  const auto write = [&](const char* who, const std::vector<double>& seconds) {
    const double elements = static_cast<double>(std::max<std::size_t>(sets.both.size(), 1));
    std::printf("%s,%zu,%zu,%zu,%s,%.1f,%.2f\n", sets.name.c_str(), sets.first.size(),
                sets.second.size(), pairs, who, median(seconds) * 1e9 / elements,
                median(seconds) / median(own));
  };
  write("abut", own);
  write("one set filtered", filtered);
  write("cgal_box", theirs);
  return agree;
}

int main_of(int argc, char** argv) {
  CommandLine command_line("Times the search of one set against another; CSV on stdout.");
  std::size_t count = 1'000'000;
  int repetitions = 5;
  std::string name = "dense";
  command_line.add("--scene", name, "in 3D: the second set, or both are parts of it");
  command_line.add("--count", count, "elements of the scene");
  command_line.add("--repetitions", repetitions, "medians of so many", {1.0, 1000.0});
  if (const auto exit_code = command_line.read(argc, argv)) return *exit_code;

  const scenes::Scene scene = scenes::scene_named(name).make(count, 1);
  std::puts("case,first,second,contact_pairs,contestant,ns,times_abut");
  bool agree = true;
  for (const TwoScenes& sets :
       {probes_in(scene), slab_against_rest(scene), every_other(scene), far_apart(scene)}) {
    agree = measure(sets, repetitions) && agree;
  }
  return agree ? EXIT_SUCCESS : different_answers;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("cross_contacts", abut::benchmarks::main_of, argc, argv);
}
