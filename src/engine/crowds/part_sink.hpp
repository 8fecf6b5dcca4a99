#pragma once

#include "base/pair_sink.hpp"

#include <cstddef>
#include <span>

namespace abut::engine {

/// Takes the pairs of a part that one worker searches within a unit of its own: they belong to that
/// unit.
class PartSink final : public base::PairSink {
 public:
  PartSink(base::PairSink& whole, const base::Origin& origin) : whole_(whole), origin_(origin) {}

  void expect_workers(std::size_t) override {}
  [[nodiscard]] std::span<ContactPair> buffer(std::size_t) override {
    return whole_.buffer(origin_.worker);
  }
  void commit(std::size_t count, const base::Origin&) override { whole_.commit(count, origin_); }

 private:
  base::PairSink& whole_;
  base::Origin origin_;
};

}  // namespace abut::engine
