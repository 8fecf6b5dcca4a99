#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::device {

/// What CUDA aligns its blocks to, and what blocks in one array are aligned to.
inline constexpr std::uint64_t block_alignment = 256;

[[nodiscard]] constexpr std::uint64_t aligned_block(std::uint64_t bytes) noexcept {
  return (bytes + block_alignment - 1) / block_alignment * block_alignment;
}

/// A block that a call took. Steps of a call are what it takes and gives back, counted together.
struct PlacedBlock {
  std::uint64_t bytes;                                            ///< aligned
  std::uint64_t begin;                                            ///< the step that took it
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();  ///< that gave it back
  std::uint64_t place = 0;                                        ///< in one array

  [[nodiscard]] std::uint64_t end_place() const noexcept { return place + bytes; }
  [[nodiscard]] bool is_beside_in_time(const PlacedBlock& other) const noexcept {
    return begin < other.end && other.begin < end;
  }
};

/// What a call takes and gives back, in the order in which it does.
class BlockSequence {
 public:
  /// Notes a block; returns its number.
  std::size_t take(std::uint64_t bytes) {
    blocks_.push_back({.bytes = aligned_block(bytes), .begin = steps_});
    ++steps_;
    return blocks_.size() - 1;
  }
  void place(std::size_t number, std::uint64_t place) noexcept { blocks_[number].place = place; }
  void give_back(std::size_t number) noexcept { blocks_[number].end = steps_++; }

  /// Forgets a block that could not be had, as soon as it is noted.
  void forget_last() noexcept {
    blocks_.pop_back();
    --steps_;
  }
  void forget_all() noexcept {
    blocks_.clear();
    steps_ = 0;
  }

  /// In the order in which they were taken.
  [[nodiscard]] const std::vector<PlacedBlock>& blocks() const noexcept { return blocks_; }

 private:
  std::vector<PlacedBlock> blocks_;
  std::uint64_t steps_ = 0;
};

}  // namespace abut::device
