#pragma once

#include "answer.hpp"
#include "element_sets.hpp"
#include "io/snapshot.hpp"
#include "measurement.hpp"
#include "options/rule_options.hpp"

#include <string>
#include <vector>

namespace abut::cli {

/// The list in canonical order that took the least time; null if there is none.
[[nodiscard]] const Measurement* fastest_list(const std::vector<Measurement>& measurements);

[[nodiscard]] std::vector<Answer> answers_of(const std::vector<Measurement>& measurements);

/// A table for people.
[[nodiscard]] std::string bench_text(const ElementSets& sets, const LoadedRule& rule,
                                     const std::vector<Measurement>& measurements);

/// Returns the report, and more, as one JSON object.
[[nodiscard]] std::string bench_json(const io::Snapshot& snapshot,
                                     const std::vector<Measurement>& measurements);

}  // namespace abut::cli
