#pragma once

#include <abut/export.hpp>
#include <abut/pair.hpp>
#include <abut/statistics.hpp>

#include <span>
#include <utility>
#include <vector>

namespace abut {

/// The contact pairs of one detection, each once, in the order that was asked for.
class PairList {
 public:
  PairList() = default;
  PairList(std::vector<ContactPair> pairs, Statistics statistics)
      : pairs_(std::move(pairs)), statistics_(std::move(statistics)) {}

  [[nodiscard]] PairCount size() const noexcept { return pairs_.size(); }
  [[nodiscard]] bool empty() const noexcept { return pairs_.empty(); }
  [[nodiscard]] const ContactPair& operator[](PairCount k) const noexcept { return pairs_[k]; }
  [[nodiscard]] auto begin() const noexcept { return pairs_.begin(); }
  [[nodiscard]] auto end() const noexcept { return pairs_.end(); }
  [[nodiscard]] std::span<const ContactPair> pairs() const noexcept { return pairs_; }

  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  std::vector<ContactPair> pairs_;
  Statistics statistics_;
};

}  // namespace abut
