#pragma once

#include "fuzz/fuzz_case.hpp"

#include <string>

namespace abut::fuzz {

/// The case as text: each state with its domain, margin and rule, and its elements as a CSV file
/// that the tool reads.
[[nodiscard]] std::string dump_case(const Case& given);

}  // namespace abut::fuzz
