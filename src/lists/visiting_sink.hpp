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

namespace abut::lists {

/// The visitor that pairs are handed to: one of the two, or none, and then they are only counted.
struct Visitors {
  const PairBatchVisitor* of_pairs = nullptr;
  const ShiftedBatchVisitor* of_shifted_pairs = nullptr;
};

/// An empty visitor is nobody.
[[nodiscard]] inline Visitors visitors_of(const PairBatchVisitor& visitor) {
  return {visitor ? &visitor : nullptr, nullptr};
}
[[nodiscard]] inline Visitors visitors_of(const ShiftedBatchVisitor& visitor) {
  return {nullptr, visitor ? &visitor : nullptr};
}

/// Hands pairs to the caller's visitor, or only counts them. It keeps its buffers.
class VisitingSink final : public base::PairSink {
 public:
  void start_anew(PairCount limit, const Visitors& visitors) {
    limit_ = limit;
    visitors_ = visitors;
    count_ = 0;
    for (const auto& buffer : buffers_) buffer->holds_shifts = false;
  }

  [[nodiscard]] PairCount count() const noexcept { return count_; }

  void expect_workers(std::size_t count) override {
    while (buffers_.size() < count) buffers_.push_back(std::make_unique<VisitBuffer>());
  }

  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) override {
    return buffers_[worker]->pairs;
  }

  [[nodiscard]] std::span<ImageShift> shift_buffer(std::size_t worker) override {
    if (visitors_.of_shifted_pairs == nullptr) return {};
    VisitBuffer& buffer = *buffers_[worker];
    if (buffer.shifts == nullptr) buffer.shifts = std::make_unique<ShiftBuffer>();
    buffer.holds_shifts = true;
    return *buffer.shifts;
  }

  void commit(std::size_t count, const base::Origin& origin) override {
    if ((count_ += count) > limit_) {
      throw Error(ErrorCode::limit_exceeded,
                  "there are more than " + std::to_string(limit_) +
                      " contact pairs, the limit that was set; raise it");
    }
    const auto worker = static_cast<WorkerNumber>(origin.worker);
    const VisitBuffer& buffer = *buffers_[origin.worker];
    const auto found = std::span<const ContactPair>(buffer.pairs).first(count);
    if (visitors_.of_pairs != nullptr) {
      base::call_back([&] { (*visitors_.of_pairs)(found, worker); });
    } else if (visitors_.of_shifted_pairs != nullptr) {
      const std::span<const ImageShift> all = buffer.holds_shifts ? *buffer.shifts : no_shifts;
      base::call_back([&] { (*visitors_.of_shifted_pairs)(found, all.first(count), worker); });
    }
  }

 private:
  static constexpr std::size_t buffer_size = 2048;  // 16 KiB of pairs stay in the first cache
  using ShiftBuffer = std::array<ImageShift, buffer_size>;

  struct VisitBuffer {
    std::array<ContactPair, buffer_size> pairs;
    std::unique_ptr<ShiftBuffer> shifts;
    bool holds_shifts = false;  ///< of this detection: those of open domains write none
  };

  static constexpr ShiftBuffer no_shifts{};

  PairCount limit_ = unlimited_pairs;
  Visitors visitors_;
  std::vector<std::unique_ptr<VisitBuffer>> buffers_;
  std::atomic<PairCount> count_ = 0;
};

}  // namespace abut::lists
