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

/// Whom pairs are handed to: one of the two, or nobody, and then they are only counted.
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

/// Hands pairs to the caller's visitor, or only counts them. It keeps its rooms.
class VisitingSink final : public base::PairSink {
 public:
  void start_anew(PairCount limit, const Visitors& visitors) {
    limit_ = limit;
    visitors_ = visitors;
    count_ = 0;
    for (const auto& room : rooms_) room->holds_shifts = false;
  }

  [[nodiscard]] PairCount count() const noexcept { return count_; }

  void expect_workers(std::size_t count) override {
    while (rooms_.size() < count) rooms_.push_back(std::make_unique<Room>());
  }

  [[nodiscard]] std::span<ContactPair> room(std::size_t worker) override {
    return rooms_[worker]->pairs;
  }

  [[nodiscard]] std::span<ImageShift> shift_room(std::size_t worker) override {
    if (visitors_.of_shifted_pairs == nullptr) return {};
    Room& room = *rooms_[worker];
    if (room.shifts == nullptr) room.shifts = std::make_unique<RoomShifts>();
    room.holds_shifts = true;
    return *room.shifts;
  }

  void commit(std::size_t count, const base::Origin& origin) override {
    if ((count_ += count) > limit_) {
      throw Error(ErrorCode::limit_exceeded,
                  "there are more than " + std::to_string(limit_) +
                      " contact pairs, the limit that was set; raise it");
    }
    const auto worker = static_cast<WorkerNumber>(origin.worker);
    const Room& room = *rooms_[origin.worker];
    const auto found = std::span<const ContactPair>(room.pairs).first(count);
    if (visitors_.of_pairs != nullptr) {
      base::call_back([&] { (*visitors_.of_pairs)(found, worker); });
    } else if (visitors_.of_shifted_pairs != nullptr) {
      const std::span<const ImageShift> all = room.holds_shifts ? *room.shifts : no_shifts;
      base::call_back([&] { (*visitors_.of_shifted_pairs)(found, all.first(count), worker); });
    }
  }

 private:
  static constexpr std::size_t room_size = 2048;  // 16 KiB of pairs stay in the first cache
  using RoomShifts = std::array<ImageShift, room_size>;

  struct Room {
    std::array<ContactPair, room_size> pairs;
    std::unique_ptr<RoomShifts> shifts;
    bool holds_shifts = false;  ///< of this detection: those of open domains write none
  };

  static constexpr RoomShifts no_shifts{};

  PairCount limit_ = unlimited_pairs;
  Visitors visitors_;
  std::vector<std::unique_ptr<Room>> rooms_;
  std::atomic<PairCount> count_ = 0;
};

}  // namespace abut::api
