#include "fuzz/check_candidates.hpp"

#include <abut/error.hpp>

#include <string>
#include <utility>

namespace abut::fuzz {
namespace {

/// Candidates may be as many as a long skin makes them.
constexpr PairCount most_candidates = 100'000;

}  // namespace

/// Only positions have changed, and not too much.
bool CandidateChecker::serves(const Question& question) const {
  const System& now = question.system();
  return candidates_.has_value() && now.domain == then_.domain && now.margin == then_.margin &&
         now.first.radius == then_.first.radius && !candidates_->needs_rebuild(question.first());
}

/// Without the rule, which the list would look at again when it is made anew, and which only takes
/// pairs away.
void CandidateChecker::rebuild(const Question& question) {
  candidates_.reset();
  entries_.clear();
  Options options;
  options.margin = question.system().margin;
  options.shifts = Shifts::stored;
  options.max_pairs = most_candidates;
  options.threads = 1;
  CandidateList made(skin_.length(), NeighborListKind::half, options);
  try {
    made.rebuild(question.first(), question.domain());
  } catch (const Error& error) {
    // With the skin elements may reach too far, or over too many images.
    if (error.code() == ErrorCode::invalid_input || error.code() == ErrorCode::limit_exceeded) {
      return;
    }
    throw;
  }
  const NeighborList& rows = made.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      entries_.insert({static_cast<ElementIndex>(i), rows[i][k], rows.shifts_of(i)[k]});
    }
  }
  candidates_ = std::move(made);
  then_ = question.system();
}

void CandidateChecker::check(const Question& question) {
  if (skin_.kind() != Skin::Kind::fixed || question.has_two_sets()) return;
  if (question.system().first.shape == Shape::box) return;
  const bool kept = serves(question);
  if (!kept) rebuild(question);
  if (!candidates_) return;
  for (const auto& [pair, shift] : question.expected().pairs) {
    if (entries_.contains({pair.first, pair.second, shift})) continue;
    throw Failure("pair (" + std::to_string(pair.first) + ", " + std::to_string(pair.second) +
                  ") is no candidate of a list " + (kept ? "that was kept" : "made anew"));
  }
}

}  // namespace abut::fuzz
