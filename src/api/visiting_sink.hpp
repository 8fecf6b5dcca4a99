#pragma once

#include "base/callers_exception.hpp"
#include "base/pair_sink.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/pair.hpp>

#include <array>
#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace abut::api {

/// Hands pairs to the caller's visitor, or only counts them. It keeps its rooms.
class VisitingSink final : public base::PairSink {
 public:
  /// Counts only without a visitor.
  void start_anew(PairCount limit, const PairBatchVisitor* visitor) {
    limit_ = limit;
    visitor_ = visitor;
    count_ = 0;
  }

  [[nodiscard]] PairCount count() const noexcept { return count_; }

  void expect_workers(std::size_t count) override {
    while (rooms_.size() < count) rooms_.push_back(std::make_unique<Room>());
  }

  [[nodiscard]] std::span<ContactPair> room(std::size_t worker) override { return *rooms_[worker]; }

  void commit(std::size_t count, const base::Origin& origin) override {
    if ((count_ += count) > limit_) {
      throw Error(ErrorCode::limit_exceeded,
                  "there are more than " + std::to_string(limit_) +
                      " contact pairs, the limit that was set; raise it");
    }
    if (visitor_ == nullptr) return;
    const auto found = std::span<const ContactPair>(*rooms_[origin.worker]).first(count);
    base::call_back([&] { (*visitor_)(found, static_cast<WorkerNumber>(origin.worker)); });
  }

 private:
  /// 16 KiB, so that it stays in the first cache.
  using Room = std::array<ContactPair, 2048>;

  PairCount limit_ = unlimited_pairs;
  const PairBatchVisitor* visitor_ = nullptr;
  std::vector<std::unique_ptr<Room>> rooms_;
  std::atomic<PairCount> count_ = 0;
};

}  // namespace abut::api
