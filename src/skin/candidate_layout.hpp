#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "kernels/candidate_kernels.hpp"
#include "kernels/order_kernels.hpp"
#include "lists/found_pairs.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::skin {

using kernels::SlotPair;

/// Number of an image shift in a list in ascending order of the few different ones.
using ShiftNumber = std::uint16_t;

/// Candidates in two orders. They are tested in that of space, in which partners are at hand,
/// though numbers need not follow space: elements that have candidates stand in *slots*, in the
/// order in which the search came across them, and the candidates of which an element is the first
/// lie together where it does. They are delivered in canonical order. Where numbers do follow space
/// the two orders are one: each element is its own slot.
class CandidateLayout {
 public:
  explicit CandidateLayout(base::MemoryMeter& memory);

  /// Takes other kernels than plain C++.
  void use(const kernels::OrderKernels& kernels) noexcept { kernels_ = kernels; }

  /// Arranges candidates, fewer than 2^32, from the pieces in which they were found. `shifts` holds
  /// the numbers of their shifts one after the other, or nothing.
  void arrange(lists::PairPieces found, std::span<const ShiftNumber> shifts,
               std::size_t element_count, std::size_t workers, base::WorkCounter& work);

  /// True if candidates() are in canonical order, and slots are elements.
  [[nodiscard]] bool follows_space() const noexcept { return follows_space_; }

  [[nodiscard]] std::size_t slot_count() const noexcept { return slot_count_; }
  /// The elements in the slots; null where slots are elements.
  [[nodiscard]] const ElementIndex* elements() const noexcept {
    return follows_space_ ? nullptr : elements_.data();
  }
  /// The slot of each element, at least slot_count() where it has none; null where slots are
  /// elements.
  [[nodiscard]] const std::uint32_t* slots_of_elements() const noexcept {
    return follows_space_ ? nullptr : slot_of_.data();
  }
  [[nodiscard]] ContactPair pair_of(const SlotPair& slots) const noexcept {
    if (follows_space_) return {slots.first, slots.second};
    return {elements_[slots.first], elements_[slots.second]};
  }
  /// The candidates in the order of space; shifts() has the numbers of their shifts.
  [[nodiscard]] std::span<const SlotPair> candidates() const noexcept {
    return {candidates_.data(), size_};
  }
  [[nodiscard]] const ShiftNumber* shifts() const noexcept { return shifts_.data(); }

  /// Candidates in canonical order, their places in the order of space, and their shifts; only
  /// where the two orders differ.
  struct Canonical {
    const ContactPair* pairs;
    const std::uint32_t* places;
    const ShiftNumber* shifts;
  };
  [[nodiscard]] Canonical canonical() const noexcept {
    return {pairs_.data(), places_.data(), canonical_shifts_.data()};
  }

 private:
  void take_elements_as_slots(lists::PairPieces found, std::size_t element_count,
                              base::WorkCounter& work);
  void give_slots(lists::PairPieces found, std::size_t element_count, base::WorkCounter& work);
  void collect_runs(lists::PairPieces found, std::span<const ShiftNumber> shifts,
                    base::WorkCounter& work);
  void sort_runs(std::size_t first_slot, std::size_t last_slot, base::WorkCounter& work);
  [[nodiscard]] std::size_t sort_short_runs(std::size_t first_slot, std::size_t last_slot);
  void list_run(std::size_t slot);
  void list_canonically(std::size_t element_count, std::size_t workers, base::WorkCounter& work);
  void list_canonically(std::size_t first_element, std::size_t last_element, std::size_t place,
                        base::WorkCounter& work);
  [[nodiscard]] std::size_t candidates_of(std::size_t first, std::size_t last,
                                          base::WorkCounter& work) const;

  [[nodiscard]] std::uint32_t slot_of(ElementIndex element) const noexcept {
    return follows_space_ ? element : slot_of_[element];
  }

  bool follows_space_ = false;
  bool with_shifts_ = false;
  std::size_t slot_count_ = 0;
  std::size_t size_ = 0;
  base::Array<std::uint32_t> slot_of_;  ///< of each element; no_slot without candidates
  base::Array<ElementIndex> elements_;
  base::Array<std::uint32_t> end_;   ///< of each slot's candidates, behind the begin of the first
  base::Array<std::uint64_t> keys_;  ///< second element, then shift; in the order of space
  base::Array<SlotPair> candidates_;
  base::Array<ShiftNumber> shifts_;
  base::Array<ContactPair> pairs_;
  base::Array<std::uint32_t> places_;
  base::Array<ShiftNumber> canonical_shifts_;
  kernels::OrderKernels kernels_;
  std::vector<std::size_t> begins_;  ///< of each worker's share in canonical order
};

}  // namespace abut::skin
