#pragma once

#include "device/memory/block_sequence.hpp"
#include "device/memory/place_finder.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace abut::device {

/// Looks for an order in which PlaceFinder makes an array shorter than the blocks of a call make it
/// as they lie. Large blocks go first; then those that are there when most is held, and two of them
/// change their turns again and again. A block that the array became too long for is one of these
/// from then on. It ends after some thousand changes where the array is still too long; what it
/// finds is the same each time.
class OrderSearch {
 public:
  /// The first blocks keep their places. All hold so many bytes at once at most, and lie in an
  /// array of that length.
  OrderSearch(std::vector<PlacedBlock>& blocks, std::size_t placed, std::uint64_t length,
              std::uint64_t most_held);

  /// Places the blocks in an array no longer than `short_enough`, if it finds how; returns the
  /// length of the array.
  std::uint64_t run(std::uint64_t short_enough);

 private:
  using TwoTurns = std::array<std::size_t, 2>;
  [[nodiscard]] TwoTurns any_two() noexcept {
    return {placed_ + random_() % fullest_, placed_ + random_() % fullest_};
  }
  void change(const TwoTurns& turns) noexcept { std::swap(order_[turns[0]], order_[turns[1]]); }

  [[nodiscard]] bool is_done() const noexcept { return length_ <= short_enough_; }
  /// Places all in this order; returns whether the array became shorter.
  bool place_all();
  void put_heaviest_first(const auto& weight_of);
  void place_by(const auto& weight_of);
  void put_fullest_first();
  void change_turns();
  void take_among_fullest(std::size_t turn);
  [[nodiscard]] std::uint64_t length_of_fullest(std::uint64_t limit);

  std::vector<PlacedBlock>& best_;
  std::vector<PlacedBlock> blocks_;
  std::size_t placed_;
  PlaceFinder finder_;
  std::uint64_t length_;
  std::uint64_t most_held_;
  std::uint64_t short_enough_ = 0;
  std::vector<std::size_t> order_;
  std::size_t fullest_ = 0;  ///< so many behind those that have places change their turns
  std::minstd_rand random_;
};

}  // namespace abut::device
