#pragma once

#include "base/memory_meter.hpp"
#include "base/pair_sink.hpp"

#include <abut/error.hpp>
#include <abut/pair.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace abut::api {

/// Stores pairs, up to the limit and the memory bound.
class ListSink final : public base::PairSink {
 public:
  ListSink(PairCount limit, base::MemoryMeter& memory) : limit_(limit), memory_(memory) {}
  ~ListSink() override { memory_.give_back_pairs(accounted_); }

  ListSink(const ListSink&) = delete;
  ListSink& operator=(const ListSink&) = delete;

  std::vector<ContactPair> pairs;

 private:
  void receive(std::span<const ContactPair> found) override {
    if (found.size() > limit_ - pairs.size()) {
      throw Error(ErrorCode::limit_exceeded,
                  "there are more than " + std::to_string(limit_) +
                      " contact pairs, the limit that was set; raise it, or count the pairs "
                      "without storing them");
    }
    account(pairs.size() + found.size());
    pairs.insert(pairs.end(), found.begin(), found.end());
  }

  /// Grows by half, so that old and new storage together stay below 2.5 times the pairs.
  void account(std::size_t needed) {
    if (needed <= pairs.capacity()) return;
    const std::size_t capacity = std::max(needed, pairs.capacity() + pairs.capacity() / 2);
    const std::uint64_t bytes = capacity * sizeof(ContactPair);
    memory_.take_for_pairs(bytes);
    try {
      pairs.reserve(capacity);
    } catch (...) {
      memory_.give_back_pairs(bytes);
      throw;
    }
    memory_.give_back_pairs(accounted_);
    accounted_ = bytes;
  }

  PairCount limit_;
  base::MemoryMeter& memory_;
  std::uint64_t accounted_ = 0;
};

}  // namespace abut::api
