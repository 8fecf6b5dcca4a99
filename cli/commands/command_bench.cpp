#include "commands/command_bench.hpp"

#include "device_search.hpp"
#include "measurement.hpp"
#include "talk.hpp"
#include "text/bench_report.hpp"

#include <array>
#include <utility>

namespace abut::cli {
namespace {

/// Seconds for all repetitions together, where their number is not given.
constexpr double seconds_in_all = 4.0;

/// Seconds of a first call beyond which algorithms other than `rows` are left out unless asked for.
constexpr double longest_first_call = 0.5;

constexpr std::array forms_of_every_algorithm{Form::canonical, Form::as_found};
constexpr std::array forms_of_the_best{Form::count, Form::half_list, Form::full_list};
constexpr std::array forms_of_a_device{Form::canonical, Form::count};

/// `rows` first: the answer that the others are compared with. Those that do not support the domain
/// are left out unless asked for, and beside a device all others.
std::vector<Algorithm> algorithms_of(const BenchOptions& options, const Domain& domain) {
  if (!options.algorithms.empty()) return options.algorithms;
  std::vector<Algorithm> all{Algorithm::rows};
  if (options.device) return all;
  for (const AlgorithmInfo& row : algorithms()) {
    if (row.algorithm == Algorithm::rows || (domain.is_periodic() && !row.periodic)) continue;
    all.push_back(row.algorithm);
  }
  return all;
}

/// One after the other measures what the options ask for.
class Bench {
 public:
  Bench(const BenchOptions& options, const ElementSets& sets, const LoadedRule& rule,
        Console& console)
      : options_(options),
        snapshot_(sets.first),
        domain_(sets.domain),
        rule_(rule),
        console_(console),
        threads_(options.threads) {
    if (threads_.empty()) threads_ = {1, 0};
  }

  [[nodiscard]] std::vector<Measurement> run() {
    const std::vector<Algorithm> algorithms = algorithms_of(options_, domain_);
    // Most algorithms use one thread whatever they are asked for.
    planned_ = (algorithms.size() + threads_.size() - 1) * forms_of_every_algorithm.size() +
               forms_of_the_best.size() + forms_of_a_device.size();
    for (const Algorithm algorithm : algorithms) add_algorithm(algorithm);
    if (const Measurement* const best = fastest_list(measurements_)) {
      Subject subject = best->subject;
      for (const Form form : forms_of_the_best) {
        subject.form = form;
        measurements_.push_back(measured(subject, {}));
      }
    }
    add_device();
    return std::move(measurements_);
  }

 private:
  void add_device() {
    if (!options_.device) return;
    for (const Form form : forms_of_a_device) {
      const Subject subject{Algorithm::rows, 0, form, options_.device};
      measurements_.push_back(in_words_of_tool([&] { return measured(subject, {}); }));
    }
  }

  void add_algorithm(Algorithm algorithm) {
    std::vector<int> measured_threads;
    for (const int threads : threads_) {
      Subject subject{algorithm, threads, Form::canonical};
      Measurement list = measured(subject, measured_threads);
      if (list.threads_are_measured) {
        if (!options_.threads.empty()) measurements_.push_back(std::move(list));
        continue;
      }
      measured_threads.push_back(list.statistics.threads);
      measurements_.push_back(std::move(list));
      if (!measurements_.back().has_result()) return;
      subject.form = Form::as_found;
      measurements_.push_back(measured(subject, {}));
    }
  }

  [[nodiscard]] Measurement measured(const Subject& subject,
                                     const std::vector<int>& measured_threads) {
    Effort effort{
        options_.repetitions, seconds_in_all / static_cast<double>(planned_), {}, measured_threads};
    if (options_.algorithms.empty() && subject.algorithm != Algorithm::rows) {
      effort.first_call_seconds = longest_first_call;
    }
    Options detection;
    detection.margin = options_.margin;
    detection.max_bytes = options_.max_bytes;
    detection.rule = rule_.rule();
    return measure(subject, snapshot_.elements(), domain_, detection, effort, console_);
  }

  const BenchOptions& options_;
  const io::Snapshot& snapshot_;
  const Domain& domain_;
  const LoadedRule& rule_;
  Console& console_;
  std::vector<int> threads_;
  std::size_t planned_ = 1;  ///< measurements
  std::vector<Measurement> measurements_;
};

}  // namespace

void run(const BenchOptions& options) {
  Console console(options.console);
  require_one_standard_input({options.source.input.path, options.rule.exclude});
  if (options.device) require_device(*options.device);
  ElementSets sets;
  sets.first = load_snapshot(options.source, console);
  sets.domain = domain_of(options.source.input.domain, sets.first);
  const LoadedRule rule(options.source.input, options.rule, sets, console);
  const std::vector<Measurement> measurements = Bench(options, sets, rule, console).run();
  console.finish();
  const std::vector<Answer> answers = answers_of(measurements);
  write_out(options.listing == Listing::json ? bench_json(sets.first, measurements)
                                             : bench_text(sets, rule, measurements));
  require_equal(answers);
}

}  // namespace abut::cli
