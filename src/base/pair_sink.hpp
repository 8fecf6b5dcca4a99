#pragma once

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace abut::base {

/// The origin of pairs: the worker that found them, and their unit of work. Pairs in ascending
/// order of their units are in the `as_found` order, that of a single worker.
struct Origin {
  std::size_t worker = 0;
  std::uint64_t unit = 0;
};

/// Receives found pairs. A worker writes into a buffer of its own and commits what it wrote;
/// workers do so at the same time. Pairs that were not committed when a detection fails are dropped
/// with it.
class PairSink {
 public:
  virtual ~PairSink() = default;

  /// Least size of a buffer.
  static constexpr std::size_t smallest_buffer = 512;

  /// Announces canonical order; called before expect_workers, and not at all where pairs come in
  /// the order in which they are found.
  virtual void expect_canonical_order() {}

  /// Announces how many workers will ask for buffers; called before they do, and perhaps once more
  /// with the same number.
  virtual void expect_workers(std::size_t count) = 0;

  /// Announces that the next units are [first, first + count), and that finish_unit tells of each;
  /// called while no worker searches, and not at all for units that nobody tells of.
  virtual void expect_units(std::uint64_t first, std::size_t count) {
    static_cast<void>(first);
    static_cast<void>(count);
  }

  /// Tells that the next pairs of the worker are those of the unit.
  virtual void begin_unit(const Origin&) {}

  /// Tells that all pairs of the unit are committed.
  virtual void finish_unit(const Origin&) {}

  /// Returns a buffer for pairs, which is this worker's own until it commits.
  [[nodiscard]] virtual std::span<ContactPair> buffer(std::size_t worker) = 0;

  /// Returns a buffer for their image shifts, parallel to the buffer for pairs that was asked for
  /// last. It is empty if shifts are not wanted; they need not be written then.
  [[nodiscard]] virtual std::span<ImageShift> shift_buffer(std::size_t) { return {}; }

  /// Takes the first `count` pairs of the worker's buffer, which must ask for a new one.
  virtual void commit(std::size_t count, const Origin& origin) = 0;

 protected:
  PairSink() = default;
  PairSink(const PairSink&) = default;
  PairSink& operator=(const PairSink&) = default;
};

/// Writes the pairs of a single worker to a sink: PairWriter those of an open domain, which have no
/// image shifts, and ImagePairWriter those of a periodic one.
template <class... Shift>
class WriterOfPairs {
 public:
  explicit WriterOfPairs(PairSink& sink) : sink_(sink) { take_buffers(); }

  void push(ContactPair pair, const Shift&... shift) {
    pairs_[filled_] = pair;
    if constexpr (has_shifts) {
      if (!shifts_.empty()) (..., (shifts_[filled_] = shift));
    }
    if (++filled_ < pairs_.size()) return;
    finish();
    take_buffers();
  }

  /// Commits the rest; nothing is pushed after it.
  void finish() {
    const std::size_t count = std::exchange(filled_, 0);
    if (count > 0) sink_.commit(count, {});
  }

 private:
  static constexpr bool has_shifts = sizeof...(Shift) > 0;

  void take_buffers() {
    pairs_ = sink_.buffer(0);
    if constexpr (has_shifts) shifts_ = sink_.shift_buffer(0);
  }

  PairSink& sink_;
  std::span<ContactPair> pairs_;
  std::span<ImageShift> shifts_;  ///< empty where shifts are not wanted
  std::size_t filled_ = 0;
};

using PairWriter = WriterOfPairs<>;
using ImagePairWriter = WriterOfPairs<ImageShift>;

}  // namespace abut::base
