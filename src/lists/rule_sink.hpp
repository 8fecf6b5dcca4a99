#pragma once

#include "lists/filtering_sink.hpp"

#include <abut/pair_rule.hpp>

#include <cstddef>

namespace abut::lists {

/// Hands on the pairs that a rule allows. Pairs have the caller's numbers.
class RuleSink final : public FilteringSink {
 public:
  /// A rule that was validated; `others` is what the second elements of pairs are to it. The arrays
  /// behind both must live until the last pairs are committed.
  void start_anew(base::PairSink& next, const PairRule& rule, const PairTraits& others) {
    pass_to(next);
    rule_ = rule;
    others_ = others;
  }

 private:
  std::size_t keep(const PairBatch& batch, std::size_t worker) const override;

  PairRule rule_;
  PairTraits others_;
};

}  // namespace abut::lists
