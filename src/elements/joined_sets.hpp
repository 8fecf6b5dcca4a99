#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "elements/gathered_elements.hpp"
#include "lattice/reach_mask.hpp"

#include <abut/element_view.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace abut::elements {

/// Two sets of elements as one system: those of the first set, then those of the second; without
/// such as cannot be within reach of any of the other set. It keeps its memory.
template <int Dim>
class JoinedSets {
 public:
  explicit JoinedSets(base::MemoryMeter& memory)
      : first_(memory),
        second_(memory),
        mask_(memory),
        numbers_(base::make_array_for_overwrite<ElementIndex>(memory, 0)) {}

  /// The form in which the sets are read, and the reach for which they are searched.
  struct Search {
    GatherSettings gather;
    double margin = 0.0;
    bool open_space = true;  ///< whether nothing is periodic
  };

  /// Reads both sets into `joined`. Throws as `gather` does, naming the set too.
  void gather(const ElementView& first, const ElementView& second, const Search& search,
              GatheredElements<Dim>& joined, base::DetectionContext& context);

  /// Forgets the sets and the memory of their elements.
  void give_back_memory() noexcept {
    first_.elements.give_back_memory();
    second_.elements.give_back_memory();
  }

  /// The number of elements of the first set among those joined.
  [[nodiscard]] std::size_t first_count() const noexcept { return first_.count; }

  /// All elements of the sets, also those left out.
  [[nodiscard]] exact::Elements<Dim> first() const noexcept { return first_.elements.elements(); }
  [[nodiscard]] exact::Elements<Dim> second() const noexcept { return second_.elements.elements(); }

  /// The numbers that the joined elements have in their sets; empty if none was left out.
  [[nodiscard]] std::span<const ElementIndex> numbers() const noexcept {
    return std::span(numbers_).first(all_there_ ? 0 : first_.count + second_.count);
  }

 private:
  /// One set, and which of its elements are joined.
  struct JoinedSet {
    explicit JoinedSet(base::MemoryMeter& memory)
        : elements(memory), kept(base::make_array_for_overwrite<ElementIndex>(memory, 0)) {}

    [[nodiscard]] std::size_t size() const noexcept { return elements.spheres.size(); }

    GatheredElements<Dim> elements;
    base::Array<ElementIndex> kept;   ///< each worker's at the beginning of its share
    std::vector<std::size_t> counts;  ///< of each worker
    std::size_t count = 0;            ///< of all
  };

  void leave_out(const Search& search, base::WorkCounter& work);
  void keep_all(JoinedSet& set, std::size_t workers);
  void keep_some(JoinedSet& set, std::size_t workers, base::WorkCounter& work);
  void join(std::size_t workers, GatheredElements<Dim>& joined, base::WorkCounter& work);
  void place(const JoinedSet& set, std::size_t worker, std::size_t begin,
             GatheredElements<Dim>& joined, base::WorkCounter& work);

  JoinedSet first_;
  JoinedSet second_;
  lattice::ReachMask<Dim> mask_;
  bool all_there_ = true;
  base::Array<ElementIndex> numbers_;
};

}  // namespace abut::elements
