// Times every contestant on every scene and writes a table in CSV. benchmarks/run_matrix runs it;
// docs/benchmarks_matrix.md shows what comes out.

#include "benchmarks/matrix/apart.hpp"
#include "benchmarks/matrix/case.hpp"
#include "benchmarks/matrix/contestants.hpp"
#include "benchmarks/matrix/pinning.hpp"
#include "benchmarks/matrix/table.hpp"

#include <abut/error.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

constexpr std::uint64_t seed = 1;

struct Plan {
  std::vector<std::string> scenes{"dense",        "ordered",     "gas",          "sparse",
                                  "clusters",     "bidisperse",  "log_uniform",  "log_uniform_1000",
                                  "graded",       "graded_1000", "hexagonal_2d", "touching_cubic",
                                  "touching_fcc", "one_giant"};
  std::vector<double> counts{1e4, 1e5, 1e6, 1e7};
  std::vector<std::string> contestants;  ///< empty: all
  std::vector<int> threads{1, 2};
  Effort effort;
  bool quick = false;
};

bool takes_part(const Entry& entry, const Plan& plan) {
  const auto holds = [](const auto& list, const auto& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  return holds(plan.threads, entry.threads) &&
         (plan.contestants.empty() || holds(plan.contestants, entry.name));
}

/// Those whose pairs are believed, if they finish: the trivial algorithm, the book's for any
/// domain, then whoever stores pairs. The table says who it was.
std::vector<Entry> referees_of(const std::vector<Entry>& all) {
  std::vector<Entry> referees;
  for (const Entry& entry : all) {
    if (entry.task == Task::list && entry.threads == 1) referees.push_back(entry);
  }
  const auto rank = [](const Entry& entry) {
    constexpr std::array<std::string_view, 3> believed{"abut_direct_check", "abut_sorting_array",
                                                       "abut_rows"};
    return std::find(believed.begin(), believed.end(), entry.name) - believed.begin();
  };
  std::stable_sort(referees.begin(), referees.end(),
                   [&](const Entry& a, const Entry& b) { return rank(a) < rank(b); });
  return referees;
}

std::vector<Entry> entries_of(const Plan& plan, const std::vector<Entry>& all) {
  for (const std::string& name : plan.contestants) {
    if (std::any_of(all.begin(), all.end(), [&](const Entry& e) { return e.name == name; })) {
      continue;
    }
    throw Error(ErrorCode::wrong_usage,
                "no contestant is called '" + name + "'; `matrix list` names those found");
  }
  std::vector<Entry> entries;
  std::copy_if(all.begin(), all.end(), std::back_inserter(entries),
               [&](const Entry& entry) { return takes_part(entry, plan); });
  return entries;
}

bool all_right(const CaseResult& result) {
  return std::none_of(result.measurements.begin(), result.measurements.end(), [](const auto& m) {
    return m.trial.verdict == Verdict::wrong || m.trial.verdict == Verdict::crashed;
  });
}

/// Each case in a process of its own, which has no history. Whether all answers were right.
bool run(const Plan& plan) {
  const std::vector<Entry> all = all_contestants();
  const std::vector<Entry> entries = entries_of(plan, all);
  const std::vector<Entry> referees = referees_of(all);
  bool right = true;
  write_header();
  for (const std::string& name : plan.scenes) {
    const scenes::SceneInfo& info = scenes::scene_named(name);
    for (const double count : plan.counts) {
      const auto elements = static_cast<std::size_t>(count);
      std::fprintf(stderr, "%s, %zu elements\n", name.c_str(), elements);
      const Apart apart = run_apart([&] {
        const scenes::Scene scene = info.make(elements, seed);
        const CaseResult result = run_case(scene, entries, referees, plan.effort);
        write_case(info, elements, result);
        std::fflush(nullptr);
        if (!all_right(result)) std::_Exit(static_cast<int>(ErrorCode::check_failed));
      });
      if (apart.ending != Ending::finished) right = false;
    }
  }
  return right;
}

void list() {
  for (const Entry& entry : all_contestants()) {
    std::printf("%-24s %-10s %2d  %s\n", entry.name.c_str(),
                std::string(name_of(entry.task)).c_str(), entry.threads, entry.description.c_str());
  }
}

int main_of(int argc, char** argv) {
  CLI::App app("Times every contestant on every scene; CSV on stdout.");
  app.require_subcommand(0, 1);
  const CLI::App* list_contestants = app.add_subcommand("list", "who was found");
  Plan plan;
  app.add_option("--scenes", plan.scenes, "names, as `abut generate --list` gives them")
      ->delimiter(',');
  app.add_option("--counts", plan.counts, "numbers of elements, such as 1e5,1e6")->delimiter(',');
  app.add_option("--contestants", plan.contestants, "names, as `matrix list` gives them")
      ->delimiter(',');
  app.add_option("--threads", plan.threads, "numbers of threads, for those that have them")
      ->delimiter(',');
  app.add_option("--time-limit", plan.effort.time_limit, "seconds for one run");
  app.add_option("--seconds", plan.effort.seconds, "of timed runs for each contestant and scene");
  app.add_option("--repetitions", plan.effort.most_repetitions, "timed runs at most, 0 for none");
  CLI11_PARSE(app, argc, argv);
  if (list_contestants->parsed()) {
    list();
    return EXIT_SUCCESS;
  }
  pin_to_one_processor();
  return run(plan) ? EXIT_SUCCESS : static_cast<int>(ErrorCode::check_failed);
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  abut::benchmarks::bind_openmp_threads(argv);
  try {
    return abut::benchmarks::main_of(argc, argv);
  } catch (const abut::Error& error) {
    std::fprintf(stderr, "matrix: %s\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "matrix: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
