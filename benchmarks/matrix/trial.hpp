#pragma once

#include "benchmarks/matrix/check.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include "scenes/scene.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace abut::benchmarks {

enum class Verdict {
  exact,     ///< all pairs and no others
  wrong,     ///< some are missing or too many
  refused,   ///< it says why it cannot
  too_slow,  ///< no end within the time limit
  crashed,
  unchecked,  ///< there is nothing to compare with
  left_out,   ///< not even tried, by the rules
};
[[nodiscard]] std::string_view name_of(Verdict verdict);

/// The first run of a contestant on a scene, in a fresh process, and whether its answer is right.
struct Trial {
  Verdict verdict = Verdict::left_out;
  std::string reason;
  Seconds first;
  std::uint64_t pairs = 0;
  Difference difference;
  Counters counters;

  [[nodiscard]] bool can_run() const {
    return verdict == Verdict::exact || verdict == Verdict::wrong || verdict == Verdict::unchecked;
  }
};

/// The right pairs of a scene, ascending.
struct Reference {
  std::string name;  ///< who found them; empty: nobody
  std::span<const ContactPair> pairs;
};

/// Runs `entry` in a process of its own and compares its answer; seconds of time limit.
[[nodiscard]] Trial try_apart(const Entry& entry, const scenes::Scene& scene,
                              const Reference& reference, unsigned time_limit);

/// The same, but where it finishes its pairs become the reference. They are never given back.
[[nodiscard]] Trial try_as_reference(const Entry& entry, const scenes::Scene& scene,
                                     Reference& reference, unsigned time_limit);

/// Runs `entry` once more in a fresh process and compares nothing; the time, if it ends well.
[[nodiscard]] std::optional<Seconds> first_run_apart(const Entry& entry, const scenes::Scene& scene,
                                                     unsigned time_limit);

/// Wall and CPU time of one run, by the contestant's own clock if it has one.
[[nodiscard]] Seconds timed_run(Contestant& contestant, const scenes::Scene& scene, Answer& answer);

}  // namespace abut::benchmarks
