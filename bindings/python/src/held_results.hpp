#pragma once

#include <abut/neighbor_list.hpp>
#include <abut/pair_list.hpp>

#include <utility>

namespace abut::python {

/// A list that Python sees: its own, or that of a Detector until the next call of that.
template <class List>
class HeldResults {
 public:
  /// Keeps a list.
  explicit HeldResults(List list) : own_(std::move(list)), list_(&own_) {}
  /// Looks at a list, which another holds until `keep` is called.
  explicit HeldResults(const List* list) : list_(list) {}
  HeldResults(const HeldResults&) = delete;
  HeldResults& operator=(const HeldResults&) = delete;

  /// Takes the list over from the one who holds it; its arrays stay where they are.
  void keep(List list) {
    own_ = std::move(list);
    list_ = &own_;
  }

  [[nodiscard]] const List& list() const noexcept { return *list_; }

 private:
  List own_;
  const List* list_;
};

using PairResults = HeldResults<PairList>;
using NeighborResults = HeldResults<NeighborList>;

}  // namespace abut::python
