#pragma once

#include <abut/algorithm.hpp>
#include <abut/error.hpp>
#include <abut/pair.hpp>

#include <span>
#include <string>
#include <string_view>

/// The judgement of commands that run several algorithms on their answers: the same pairs, or a
/// fault.
namespace abut::cli {

/// The answer of one algorithm.
struct Answer {
  std::string who;
  PairCount contact_pairs = 0;
  std::string digest;  ///< of the pairs in canonical order; empty if they were only counted
};

/// Tells whether there are answers and all are those of the first, which has a digest.
[[nodiscard]] bool all_equal(std::span<const Answer> answers);

/// Throws Error{check_failed} naming the first two that differ, Error{limit_exceeded} if there is
/// no answer.
void require_equal(std::span<const Answer> answers);

/// A line with the digest; empty unless all are equal.
[[nodiscard]] std::string equality_line(std::span<const Answer> answers);

/// Why an algorithm did not run, up to the advice of the sentence. Throws the error again unless a
/// limit was the reason.
[[nodiscard]] std::string refusal(const Error& error);

/// Returns that sentence as an indented line that names the algorithm, where the sentence does not
/// begin so.
[[nodiscard]] std::string refusal_line(std::string_view name, const std::string& refusal);

}  // namespace abut::cli
