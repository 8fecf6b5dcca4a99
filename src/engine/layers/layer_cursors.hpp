#pragma once

#include "base/array.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Places of what several workers write, sorted by layer: each counts what it will write to each
/// layer, then all counts become cursors. What one worker writes to a layer stands behind what the
/// workers before it write there, so that the order does not depend on their number.
///
///   places   | layer 0: worker 0, worker 1, ... | layer 1: worker 0, ...
///            ^ begin(0)                         ^ begin(1)
class LayerCursors {
 public:
  explicit LayerCursors(base::MemoryMeter& memory);

  /// Sets all counts to 0.
  void start(std::size_t layers, std::size_t workers);

  /// Counts of a worker by layer, and after `lay_out` its next places.
  [[nodiscard]] std::uint64_t* of(std::size_t worker) noexcept {
    return cursors_.data() + worker * layers_;
  }

  /// Turns counts into places.
  void lay_out() noexcept;

  [[nodiscard]] std::size_t begin(std::size_t layer) const noexcept { return begin_[layer]; }
  [[nodiscard]] std::size_t size(std::size_t layer) const noexcept {
    return begin_[layer + 1] - begin_[layer];
  }
  [[nodiscard]] std::size_t total() const noexcept { return begin_[layers_]; }
  /// The most in a layer.
  [[nodiscard]] std::size_t largest() const noexcept { return largest_; }

 private:
  base::Array<std::uint64_t> begin_;    ///< layers + 1
  base::Array<std::uint64_t> cursors_;  ///< of each worker, by layer
  std::size_t layers_ = 0;
  std::size_t workers_ = 0;
  std::size_t largest_ = 0;
};

}  // namespace abut::engine
