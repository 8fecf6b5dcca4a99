#pragma once

#include "device/memory/block_places.hpp"
#include "device/memory/block_plan.hpp"
#include "device/memory/block_sequence.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::device {

/// Plans of one array for calls that take turns, the last one used in front. A call follows the
/// front one as long as it takes the same blocks or smaller ones in the same steps, and goes over
/// to another that has begun in the same way. Where it follows none, a plan is a proposal only:
/// what is free decides.
class BlockPlans {
 public:
  /// Plans for calls like this one, and for no others: an array is to be as short as they can do
  /// with.
  void plan_for(const BlockSequence& sequence);

  /// Plans also for calls like this one, which did not fit into the array. If it took its blocks in
  /// the steps of a plan, that is replaced: calls like those before will fit as well, and blocks
  /// that have grown have some room to grow on, so that few calls pass a plan. The array is to be
  /// longer than this one, or than for such a call alone, by a sixteenth and 16 MiB at most.
  void plan_also_for(const BlockSequence& sequence, std::uint64_t array_bytes);

  /// Length of the array that all plans need.
  [[nodiscard]] std::uint64_t length() const noexcept;

  /// A call begins.
  void restart() noexcept;
  /// Finds a place that is free for the last block of a call so far. It may end behind the array.
  [[nodiscard]] std::uint64_t place_for_last(const BlockSequence& sequence,
                                             const BlockPlaces& taken,
                                             std::uint64_t array_bytes) noexcept;

 private:
  [[nodiscard]] const PlacedBlock* find_planned(const std::vector<PlacedBlock>& taken) noexcept;
  [[nodiscard]] bool go_over(const std::vector<PlacedBlock>& taken) noexcept;
  [[nodiscard]] const PlacedBlock* find_ahead(std::uint64_t bytes) noexcept;
  [[nodiscard]] BlockPlan made_for(const BlockSequence& sequence, const BlockPlan* earlier,
                                   std::uint64_t array_bytes) const;

  std::vector<BlockPlan> plans_;
  std::size_t next_ = 0;      ///< the block of the plan in front that is expected
  std::size_t followed_ = 0;  ///< so many blocks of the call lie where they were planned
  bool is_in_step_ = true;    ///< the call has the steps of that plan so far
};

}  // namespace abut::device
