#pragma once

#include <abut/error.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace abut::testing {

/// A call of a public function. `name` is that of the exported symbol, without arguments: by it
/// check_public_calls.py finds functions that are not in the table.
struct PublicCall {
  std::string name;
  std::string what;
  std::function<void()> call;
  std::optional<ErrorCode> refusal = {};  ///< what it throws when there is memory, if anything
};

/// Adds the calls that take cells: boxes around them, simplices.
void add_cell_calls(std::vector<PublicCall>& calls);

/// Adds the calls of histories.
void add_history_calls(std::vector<PublicCall>& calls);

/// Each public function that may allocate, each of its forms, and what writes a sentence.
[[nodiscard]] std::vector<PublicCall> public_calls();

}  // namespace abut::testing
