#pragma once

#include "base/memory_meter.hpp"
#include "engine/members.hpp"
#include "engine/search_set.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace abut::engine {

/// A search set that waits, and its lists.
template <int Dim>
struct WaitingSet {
  std::unique_ptr<Members> members;
  SearchSet<Dim> set;
  std::optional<double> size_cut;  ///< where it is known that it is to be divided
  bool is_for_one = false;         ///< not worth all workers' time
  std::size_t place = 0;           ///< ascends in the order in which sets are added
};

/// Search sets that came of others. They wait until the search of these has ended, so that its
/// arrays are free: a recursion would need arrays for each depth, and a system whose density spans
/// decades is deep. Of those that came of one set the smallest is the next: each but the largest
/// has at most half of its elements, so that lists that wait are hardly longer than twice those of
/// the whole. Lists stay for later sets.
template <int Dim>
class WaitingSets {
 public:
  explicit WaitingSets(base::MemoryMeter& memory) : memory_(memory) {}

  /// Forgets what a search left that failed.
  void start();

  /// Empty lists with room for so many.
  [[nodiscard]] std::unique_ptr<Members> spare(const MemberCounts& most);

  /// Lets a set wait; lists that are much shorter than their room are copied to a smaller one.
  void add(WaitingSet<Dim> set);
  [[nodiscard]] bool empty() const noexcept { return waiting_.empty(); }
  /// The next set, one of those that came of the set taken last, if any did. Its lists last until
  /// they are let go, or the set after it is taken.
  [[nodiscard]] const WaitingSet<Dim>& take();
  /// Lets lists go that have been copied to elsewhere, those of the set taken last.
  void let_go();

 private:
  void shorten(WaitingSet<Dim>& set);

  base::MemoryMeter& memory_;
  std::vector<WaitingSet<Dim>> waiting_;
  WaitingSet<Dim> taken_{};
  std::size_t older_ = 0;  ///< that waited when it was taken
  std::vector<std::unique_ptr<Members>> spares_;
};

}  // namespace abut::engine
