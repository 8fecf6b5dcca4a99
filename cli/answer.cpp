#include "answer.hpp"

#include "text/human_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace abut::cli {
namespace {

bool differs(const Answer& answer, const Answer& reference) {
  return answer.contact_pairs != reference.contact_pairs ||
         (!answer.digest.empty() && answer.digest != reference.digest);
}

/// The first that is not that of the first; null if all agree.
const Answer* first_difference(std::span<const Answer> answers) {
  const auto found = std::find_if(answers.begin(), answers.end(), [&answers](const Answer& answer) {
    return differs(answer, answers.front());
  });
  return found == answers.end() ? nullptr : &*found;
}

}  // namespace

bool all_equal(std::span<const Answer> answers) {
  return !answers.empty() && first_difference(answers) == nullptr;
}

void require_equal(std::span<const Answer> answers) {
  if (answers.empty()) {
    throw Error(ErrorCode::limit_exceeded,
                "no algorithm ran; name others with --algorithms or raise --max-memory");
  }
  const Answer* other = first_difference(answers);
  if (other == nullptr) return;
  const Answer& reference = answers.front();
  throw Error(ErrorCode::check_failed,
              fmt::format("{} and {} found different pairs, {} and {}: a fault of abut, please "
                          "report it with the input",
                          reference.who, other->who, grouped(reference.contact_pairs),
                          grouped(other->contact_pairs)));
}

std::string equality_line(std::span<const Answer> answers) {
  if (!all_equal(answers)) return "";
  return fmt::format("all the same pairs, {}\n", answers.front().digest);
}

std::string refusal(const Error& error) {
  if (error.code() != ErrorCode::limit_exceeded) throw error;
  const std::string sentence = error.what();
  return sentence.substr(0, sentence.find(';'));
}

std::string refusal_line(std::string_view name, const std::string& refusal) {
  const std::string named =
      refusal.starts_with(name) ? refusal : fmt::format("{}: {}", name, refusal);
  return "  " + wrapped(named, 98, 4) + '\n';
}

}  // namespace abut::cli
