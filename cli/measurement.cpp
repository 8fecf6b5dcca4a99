#include "measurement.hpp"

#include "answer.hpp"
#include "interrupt.hpp"
#include "phase_seconds.hpp"
#include "text/human_text.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace abut::cli {
namespace {

constexpr std::size_t least_repetitions = 3;
constexpr std::size_t most_repetitions = 1001;

/// Cancels a detection that takes longer than `limit`.
ProgressHook hook_with_limit(double limit, const ProgressHook& hook) {
  PhaseStopwatch stopwatch;
  double spent = 0.0;
  return [=](const Progress& progress) mutable {
    spent += stopwatch.lap();
    return spent > limit ? ProgressAction::cancel : hook(progress);
  };
}

/// The first call; false with the reason where there is to be no other.
bool begins(TimedDetector& detector, const Effort& effort, Console& console,
            Measurement& measurement) {
  const std::optional<double> limit = effort.first_call_seconds;
  detector.set_progress(limit ? hook_with_limit(*limit, console.progress()) : console.progress());
  try {
    measurement.first = detector.call();
  } catch (const Error& error) {
    stop_if_interrupted();
    measurement.refusal =
        error.code() == ErrorCode::cancelled && limit
            ? fmt::format("takes longer than {} s; ask for it with --algorithms", *limit)
            : refusal(error);
    return false;
  }
  detector.set_progress(console.progress());
  if (measurement.subject.device) return true;
  const int threads = detector.statistics().threads;
  const std::vector<int>& measured = effort.measured_threads;
  measurement.threads_are_measured =
      std::find(measured.begin(), measured.end(), threads) != measured.end();
  if (!measurement.threads_are_measured) return true;
  measurement.refusal =
      fmt::format("uses {} here", counted(static_cast<std::uint64_t>(threads), "thread"));
  return false;
}

bool is_enough(const Effort& effort, std::size_t repetitions, double spent) {
  if (effort.repetitions) return repetitions >= *effort.repetitions;
  return repetitions >= most_repetitions ||
         (repetitions >= least_repetitions && spent >= effort.seconds);
}

}  // namespace

Measurement measure(const Subject& subject, const ElementView& elements, const Domain& domain,
                    Options options, const Effort& effort, Console& console) {
  options.algorithm = subject.algorithm;
  options.threads = subject.threads;
  Measurement measurement;
  measurement.subject = subject;
  TimedDetector detector(elements, domain, options, subject.form, subject.device);
  if (!begins(detector, effort, console, measurement)) return measurement;
  double spent = 0.0;
  while (!is_enough(effort, measurement.steady.size(), spent)) {
    measurement.steady.push_back(detector.call());
    spent += measurement.steady.back();
  }
  std::sort(measurement.steady.begin(), measurement.steady.end());
  measurement.statistics = detector.statistics();
  measurement.digest = console.while_shown("digest", detector.statistics().contact_pairs,
                                           [&] { return detector.digest(); });
  return measurement;
}

}  // namespace abut::cli
