#pragma once

#include "base/detection_context.hpp"
#include "base/memory_meter.hpp"
#include "base/pair_sink.hpp"
#include "detect/element_search.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/joined_sets.hpp"
#include "exact/sphere.hpp"
#include "lists/cross_sink.hpp"

#include <abut/element_view.hpp>
#include <abut/statistics.hpp>

#include <span>

namespace abut::detect {

/// Searches two sets as one system of elements and keeps the pairs between the sets. It keeps its
/// memory.
template <int Dim>
class TwoSetSearch {
 public:
  explicit TwoSetSearch(base::MemoryMeter& memory) : sets_(memory) {}

  /// Reads both sets into `joined`. Throws as elements::gather does, and names the set.
  void gather(const ElementView& first, const ElementView& second, const SearchTask& task,
              elements::GatheredElements<Dim>& joined, base::DetectionContext& context);

  /// Delivers the pairs (element of the first set, element of the second) of the sets that were
  /// gathered last.
  void search(ElementSearch<Dim>& inner, elements::GatheredElements<Dim>& joined,
              const SearchTask& task, base::PairSink& sink, base::DetectionContext& context,
              Statistics& statistics);

  /// All elements of each set, also those that were left out of the search.
  [[nodiscard]] exact::Elements<Dim> first() const noexcept { return sets_.first(); }
  [[nodiscard]] exact::Elements<Dim> second() const noexcept { return sets_.second(); }

  /// Forgets the sets and the memory of their elements.
  void give_back_memory() noexcept { sets_.give_back_memory(); }

 private:
  elements::JoinedSets<Dim> sets_;
  lists::CrossSink crossing_;
};

}  // namespace abut::detect
