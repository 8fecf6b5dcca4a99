// Times every contestant on every scene and writes a table in CSV. benchmarks/matrix/run runs it;
// docs/benchmarks_matrix.md shows what comes out.

#include "benchmarks/common/program.hpp"
#include "benchmarks/matrix/apart.hpp"
#include "benchmarks/matrix/case.hpp"
#include "benchmarks/matrix/contestants.hpp"
#include "benchmarks/matrix/pinning.hpp"
#include "benchmarks/matrix/plan.hpp"
#include "benchmarks/matrix/table.hpp"

#include <abut/error.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

constexpr std::uint64_t seed = 1;

bool all_right(const CaseResult& result) {
  return std::none_of(result.measurements.begin(), result.measurements.end(), [](const auto& m) {
    return m.trial.verdict == Verdict::wrong || m.trial.verdict == Verdict::crashed;
  });
}

/// Seconds of first runs by row of the table, infinite where they did not end.
using FirstRuns = std::array<double, 256>;

void note_first_runs(const CaseResult& result, FirstRuns& first_runs) {
  for (const Measurement& m : result.measurements) {
    double& seconds = first_runs[m.entry->number];
    if (m.trial.can_run()) seconds = m.trial.first.wall;
    if (m.trial.verdict == Verdict::too_slow) seconds = std::numeric_limits<double>::infinity();
  }
}

/// In a process of its own, which has no history. Whether all answers were right.
bool run_one_case(const scenes::SceneInfo& info, std::size_t elements, const Contestants& who,
                  const Effort& effort, FirstRuns& first_runs) {
  std::fprintf(stderr, "%s, %zu elements\n", std::string(info.name).c_str(), elements);
  const Apart apart = run_apart([&] {
    const scenes::Scene scene = info.make(elements, seed);
    const CaseResult result = run_case(scene, who.entries, who.referees, effort);
    note_first_runs(result, first_runs);
    write_case(info, elements, result);
    std::fflush(nullptr);
    if (!all_right(result)) std::_Exit(static_cast<int>(ErrorCode::check_failed));
  });
  if (apart.ending == Ending::finished) return true;
  std::fprintf(stderr, "matrix: not all is well with this case: it %s\n", apart.reason.c_str());
  return false;
}

/// No contestant needs less than in proportion to the elements.
void expect(std::vector<Entry>& entries, const FirstRuns& first_runs, double growth) {
  for (Entry& entry : entries) entry.least_seconds = first_runs[entry.number] * growth;
}

bool run(const Plan& plan, Contestants who) {
  bool right = true;
  write_header();
  for (const std::string& name : plan.scenes) {
    const scenes::SceneInfo& info = scenes::scene_named(name);
    const Shared<FirstRuns> first_runs;
    double before = 0.0;
    for (const double count : plan.counts) {
      const double growth = before > 0.0 && count > before ? count / before : 0.0;
      for (auto* entries : {&who.entries, &who.referees}) expect(*entries, *first_runs, growth);
      const auto elements = static_cast<std::size_t>(count);
      right = run_one_case(info, elements, who, plan.effort, *first_runs) && right;
      before = count;
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
  const CLI::App* list_scenes = app.add_subcommand("scenes", "what is measured unless told");
  Plan plan;
  app.add_option("--scenes", plan.scenes, "names, as `abut generate --list` gives them")
      ->delimiter(',');
  const CLI::Option* counts =
      app.add_option("--counts", plan.counts, "numbers of elements, such as 1e5,1e6")
          ->delimiter(',');
  app.add_option("--contestants", plan.contestants, "names, as `matrix list` gives them")
      ->delimiter(',');
  app.add_option("--threads", plan.threads, "numbers of threads, for those that have them")
      ->delimiter(',');
  app.add_option("--time-limit", plan.effort.time_limit, "seconds for one run");
  app.add_option("--seconds", plan.effort.seconds, "of timed runs for each contestant and scene");
  app.add_option("--repetitions", plan.effort.most_repetitions, "timed runs at most, 0 for none");
  bool quick = false;
  app.add_flag("--quick", quick, "small scenes, two repetitions: whether it works at all");
  CLI11_PARSE(app, argc, argv);
  if (quick) {
    plan.effort = {10, 0.1, 2, 3, 2};
    if (counts->empty()) plan.counts = {1e3, 1e4};
  }
  std::sort(plan.counts.begin(), plan.counts.end());
  if (list_contestants->parsed()) {
    list();
    return EXIT_SUCCESS;
  }
  if (list_scenes->parsed()) {
    for (const std::string& scene : plan.scenes) std::puts(scene.c_str());
    return EXIT_SUCCESS;
  }
  const Contestants who = contestants_of(plan);  // counts the processors
  pin_to_one_processor();
  return run(plan, who) ? EXIT_SUCCESS : static_cast<int>(ErrorCode::check_failed);
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  abut::benchmarks::bind_openmp_threads(argv);
  return abut::benchmarks::run_program("matrix", abut::benchmarks::main_of, argc, argv);
}
