#pragma once

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::base {

/// Who found pairs, and when a single worker would have: what a search delivers unit by unit, in
/// ascending order, is the `as_found` order whatever the number of workers.
struct Origin {
  std::size_t worker = 0;
  std::uint64_t unit = 0;
};

/// Where found pairs go. A worker writes into room of its own and commits what it wrote; workers do
/// so at the same time. Pairs that were not committed when a detection fails are dropped with it.
class PairSink {
 public:
  virtual ~PairSink() = default;

  /// Least size of a room.
  static constexpr std::size_t smallest_buffer = 512;

  /// Announces canonical order; called before expect_workers, and not at all where pairs come in
  /// the order in which they are found.
  virtual void expect_canonical_order() {}

  /// Announces how many workers will ask for room; called once before they do.
  virtual void expect_workers(std::size_t count) = 0;

  /// Room for pairs, this worker's own until it commits.
  [[nodiscard]] virtual std::span<ContactPair> buffer(std::size_t worker) = 0;

  /// Room for their image shifts, parallel to the room for pairs that was asked for last. Empty
  /// where shifts are not wanted; they need not be written then.
  [[nodiscard]] virtual std::span<ImageShift> shift_buffer(std::size_t) { return {}; }

  /// The first `count` pairs of the worker's room are found; it must ask for room anew.
  virtual void commit(std::size_t count, const Origin& origin) = 0;

 protected:
  PairSink() = default;
  PairSink(const PairSink&) = default;
  PairSink& operator=(const PairSink&) = default;
};

/// A single worker's pen, for pairs of an open domain.
class PairWriter {
 public:
  explicit PairWriter(PairSink& sink) : sink_(sink), room_(sink.buffer(0)) {}

  void push(ContactPair pair) {
    room_[filled_++] = pair;
    if (filled_ < room_.size()) return;
    finish();
    room_ = sink_.buffer(0);
  }

  /// Commits the rest; nothing is pushed after it.
  void finish() {
    const std::size_t count = filled_;
    filled_ = 0;
    if (count > 0) sink_.commit(count, {});
  }

 private:
  PairSink& sink_;
  std::span<ContactPair> room_;
  std::size_t filled_ = 0;
};

/// The same for pairs of a periodic domain.
class ImagePairWriter {
 public:
  explicit ImagePairWriter(PairSink& sink) : sink_(sink) { take_room(); }

  void push(ContactPair pair, const ImageShift& shift) {
    room_[filled_] = pair;
    if (!shifts_.empty()) shifts_[filled_] = shift;
    if (++filled_ < room_.size()) return;
    finish();
    take_room();
  }

  /// Commits the rest; nothing is pushed after it.
  void finish() {
    const std::size_t count = filled_;
    filled_ = 0;
    if (count > 0) sink_.commit(count, {});
  }

 private:
  void take_room() {
    room_ = sink_.buffer(0);
    shifts_ = sink_.shift_buffer(0);
  }

  PairSink& sink_;
  std::span<ContactPair> room_;
  std::span<ImageShift> shifts_;
  std::size_t filled_ = 0;
};

}  // namespace abut::base
