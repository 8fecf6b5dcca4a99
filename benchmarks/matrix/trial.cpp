#include "benchmarks/matrix/trial.hpp"

#include "benchmarks/common/timing.hpp"
#include "benchmarks/matrix/apart.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <system_error>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

/// The result that the process of a trial hands back; lies in shared memory.
struct Report {
  Verdict verdict = Verdict::crashed;
  Seconds first;
  std::uint64_t pairs = 0;
  Difference difference;
  std::uint64_t candidate_tests = 0;
  std::uint64_t peak_bytes = 0;
  std::array<char, 500> note{};
  std::array<char, 500> reason{};
};

template <std::size_t Size>
void set(std::array<char, Size>& to, const std::string& text) {
  const std::size_t length = std::min(text.size(), Size - 1);
  std::copy_n(text.data(), length, to.data());
  to[length] = '\0';
}

void write_all(int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0) throw std::system_error(errno, std::generic_category(), "write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

/// The contestant after its first run, in the process of its own, and its answer.
struct FirstRun {
  std::unique_ptr<Contestant> contestant;
  Answer answer;

  FirstRun(const Entry& entry, const Scene& scene, unsigned time_limit, Report& report) {
    limit_memory();
    contestant = entry.make();
    contestant->prepare(scene);
    start_clock(time_limit);
    report.first = timed_run(*contestant, scene, answer);
    stop_clock();
  }
};

/// In the process of its own.
void attempt(const Entry& entry, const Scene& scene, const Reference* reference, int file,
             unsigned time_limit, Report& report) {
  const FirstRun run(entry, scene, time_limit, report);
  const auto& [contestant, answer] = run;
  report.pairs = std::max<std::uint64_t>(answer.count, answer.pairs.size());
  const Counters counters = contestant->counters();
  report.candidate_tests = counters.candidate_tests;
  report.peak_bytes = counters.peak_bytes;
  set(report.note, counters.note);
  if (reference == nullptr) {
    const std::vector<ContactPair> sorted = ascending(answer.pairs);
    write_all(file, std::as_bytes(std::span(sorted)));
    report.verdict = Verdict::exact;
  } else if (reference->name.empty() && !measures_the_machine(entry.task)) {
    report.verdict = Verdict::unchecked;
  } else {
    report.difference = check(entry.task, answer, reference->pairs);
    report.verdict = report.difference.none() ? Verdict::exact : Verdict::wrong;
  }
}

Trial trial_of(const Report& report, const Apart& apart) {
  Trial trial;
  trial.verdict = report.verdict;
  trial.reason = report.reason.data();
  trial.first = report.first;
  trial.pairs = report.pairs;
  trial.difference = report.difference;
  trial.counters = {report.candidate_tests, report.peak_bytes, report.note.data()};
  if (apart.ending != Ending::finished) {
    trial.verdict = apart.ending == Ending::too_slow ? Verdict::too_slow : Verdict::crashed;
    trial.reason = apart.reason;
  }
  return trial;
}

/// What a process of its own reports of `body(report)`.
template <class Body>
Trial reported_by(Body&& body) {
  const Shared<Report> report;
  const Apart apart = run_apart([&] {
    try {
      body(*report);
    } catch (const std::bad_alloc&) {
      report->verdict = Verdict::refused;
      set(report->reason, "needs more memory than there is");
    } catch (const std::exception& error) {
      report->verdict = Verdict::refused;
      set(report->reason, error.what());
    }
  });
  return trial_of(*report, apart);
}

Trial try_into(const Entry& entry, const Scene& scene, const Reference* reference, int file,
               unsigned time_limit) {
  if (entry.most_elements > 0 && scene.size() > entry.most_elements) {
    Trial trial;
    trial.reason = entry.reason_of_limit;
    return trial;
  }
  if (entry.least_seconds > time_limit) {
    Trial trial;
    trial.verdict = Verdict::too_slow;
    trial.reason = "would not end within the time limit, going by fewer elements";
    return trial;
  }
  return reported_by(
      [&](Report& report) { attempt(entry, scene, reference, file, time_limit, report); });
}

std::span<const ContactPair> pairs_in(int file) {
  const off_t bytes = lseek(file, 0, SEEK_END);
  if (bytes <= 0) return {};
  const auto size = static_cast<std::size_t>(bytes);
  void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  return {static_cast<const ContactPair*>(memory), size / sizeof(ContactPair)};
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 7> names{"exact",   "wrong",     "refused", "too_slow",
                                                  "crashed", "unchecked", "left_out"};
  return names[static_cast<std::size_t>(verdict)];
}

Seconds timed_run(Contestant& contestant, const Scene& scene, Answer& answer) {
  const double wall = seconds_on(CLOCK_MONOTONIC);
  const double cpu = seconds_on(CLOCK_THREAD_CPUTIME_ID);
  answer = contestant.run(scene);
  const Seconds seen{seconds_on(CLOCK_MONOTONIC) - wall, seconds_on(CLOCK_THREAD_CPUTIME_ID) - cpu};
  return contestant.own_clock().value_or(seen);
}

Trial try_apart(const Entry& entry, const Scene& scene, const Reference& reference,
                unsigned time_limit) {
  return try_into(entry, scene, &reference, -1, time_limit);
}

std::optional<Seconds> first_run_apart(const Entry& entry, const Scene& scene,
                                       unsigned time_limit) {
  const Trial trial = reported_by([&](Report& report) {
    const FirstRun run(entry, scene, time_limit, report);
    report.verdict = Verdict::unchecked;
  });
  if (!trial.can_run()) return std::nullopt;
  return trial.first;
}

Trial try_as_reference(const Entry& entry, const Scene& scene, Reference& reference,
                       unsigned time_limit) {
  const int file = memfd_create("pairs", 0);
  if (file < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  const Trial trial = try_into(entry, scene, nullptr, file, time_limit);
  if (trial.verdict == Verdict::exact) reference = {entry.name, pairs_in(file)};
  close(file);
  return trial;
}

}  // namespace abut::benchmarks
