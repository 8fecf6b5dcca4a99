#pragma once

#include "scenes/scene.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace abut::benchmarks {

/// The job of a contestant, from positions and radii in separate arrays of doubles, in the
/// caller's order.
enum class Task {
  list,       ///< all contact pairs in memory, in whatever order
  canonical,  ///< the same, ascending
  count,      ///< how many there are
  visit,      ///< each handed to a visitor
  half_list,  ///< as neighbor list, each pair once
  full_list,  ///< as neighbor list, each pair from both sides
  copy,       ///< nothing but a copy of the arrays: what the memory of this machine gives
  control,    ///< nothing but arithmetic: what its processors give
};
[[nodiscard]] std::string_view name_of(Task task);

/// Tells whether the task is to measure the machine, without any answer.
[[nodiscard]] constexpr bool measures_the_machine(Task task) {
  return task == Task::copy || task == Task::control;
}

/// The pairs that one run found. `pairs` lies in the contestant's memory until its next run; first
/// < second, each pair once. Tasks that store none, or not as pairs, leave it empty and tell their
/// number.
struct Answer {
  std::span<const ContactPair> pairs;
  std::uint64_t count = 0;
};

/// Seconds of one run.
struct Seconds {
  double wall = 0.0;
  double cpu = 0.0;
};

/// Counts of a contestant about its last run, 0 where it cannot tell.
struct Counters {
  std::uint64_t candidate_tests = 0;
  std::uint64_t peak_bytes = 0;
  std::string note;  ///< its choice of an algorithm, and why
};

/// One library or method at work. It builds its structures from nothing in each run, but may keep
/// its memory from run to run. Where it cannot do a scene it throws; what() says why.
class Contestant {
 public:
  Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;
  virtual ~Contestant() = default;

  /// What a program does once, before it has any elements; not timed.
  virtual void prepare(const scenes::Scene&) {}

  virtual Answer run(const scenes::Scene& scene) = 0;

  [[nodiscard]] virtual Counters counters() const { return {}; }

  /// The contestant's own clock, where it does not run in this thread.
  [[nodiscard]] virtual std::optional<Seconds> own_clock() const { return std::nullopt; }
};

/// A row of the table of contestants.
struct Entry {
  std::string name;
  std::string description;  ///< the library and its version, or the idea
  Task task = Task::list;
  int threads = 1;
  std::size_t most_elements = 0;  ///< larger scenes are left out, 0: no limit
  std::string reason_of_limit;
  std::function<std::unique_ptr<Contestant>()> make;

  std::size_t number = 0;      ///< row of the table
  double least_seconds = 0.0;  ///< of a run, to judge by the same scene with fewer elements
};

/// Other people's libraries meet scenes of up to 10^6 elements.
[[nodiscard]] inline Entry package_entry(std::string name, std::string description) {
  Entry entry;
  entry.name = std::move(name);
  entry.description = std::move(description);
  entry.most_elements = 1'000'000;
  entry.reason_of_limit = "packaged libraries are measured up to 10^6 elements";
  return entry;
}

}  // namespace abut::benchmarks
