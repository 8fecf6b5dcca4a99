#pragma once

#include "fuzz/question.hpp"

#include <abut/candidate_list.hpp>

#include <optional>
#include <set>
#include <tuple>

namespace abut::fuzz {

/// Goes through all states with a CandidateList, which is made anew when it says so, and when more
/// than positions has changed.
class CandidateChecker {
 public:
  explicit CandidateChecker(const Skin& skin) : skin_(skin) {}

  /// Throws Failure unless the rows hold all pairs of the question.
  void check(const Question& question);

 private:
  using Entry = std::tuple<ElementIndex, ElementIndex, ImageShift>;

  [[nodiscard]] bool serves(const Question& question) const;
  void rebuild(const Question& question);

  Skin skin_;
  std::optional<CandidateList> candidates_;
  std::set<Entry> entries_;
  System then_;  ///< of which candidates were found
};

}  // namespace abut::fuzz
