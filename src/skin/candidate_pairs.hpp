#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"
#include "kernels/candidate_kernels.hpp"
#include "lists/found_pairs.hpp"
#include "skin/candidate_filter.hpp"
#include "skin/candidate_layout.hpp"
#include "skin/displacement_tracker.hpp"
#include "skin/elements_now.hpp"
#include "skin/given_spheres.hpp"
#include "skin/quanta.hpp"

#include <abut/element_view.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::skin {

/// Candidate pairs, kept from call to call: tested in the order of space, delivered in canonical
/// order. In a periodic domain with the image shift between the elements as they are placed
/// (DisplacementTracker), by number in a list of the few different ones.
template <int Dim>
class CandidatePairs {
 public:
  explicit CandidatePairs(base::MemoryMeter& memory);

  /// Most candidates that are kept of so many elements: with more a skin does not pay, and one that
  /// is many cells long would take all memory. The sink throws Error{limit_exceeded} beyond.
  [[nodiscard]] static constexpr PairCount most(std::size_t elements) noexcept {
    return (PairCount{1} << 16) + PairCount{512} * elements;
  }

  /// True if the images of one element within the margin, by whole lattice vectors of one axis
  /// each, alone span more shifts than can be numbered: the candidates could not be kept, and to
  /// look at all their images could take forever.
  [[nodiscard]] static bool too_many_shifts(const Domain& domain, double margin) noexcept;

  /// Drops all candidates and returns the sink to which a search delivers those of so many
  /// elements.
  [[nodiscard]] base::PairSink& start_anew(std::size_t elements, bool periodic);

  /// Keeps the candidates of elements that are still there, under their new numbers: element i has
  /// become `numbers[i]`, or is gone if that is ElementIds::none. Returns the sink for further
  /// ones.
  [[nodiscard]] base::PairSink& carry_over(std::span<const std::uint32_t> numbers,
                                           const DisplacementTracker<Dim>& placing,
                                           base::WorkCounter& work);

  /// Puts what the search found in order. False if there are too many of them or of different
  /// image shifts.
  [[nodiscard]] bool finish(const ElementsNow<Dim>& now, const DisplacementTracker<Dim>& placing);

  [[nodiscard]] PairCount size() const noexcept { return size_; }

  /// Brings the elements as they are placed into slots.
  void fill_slots(const ElementsNow<Dim>& now, const DisplacementTracker<Dim>& placing);

  /// Brings elements into slots as they are read, and tells how much closer two of them may have
  /// come; infinity, and no slots, where that exceeds `allowed`, an element is invalid, or slots
  /// are not to be filled so: only in open space, and where few candidates were undecided in the
  /// call before.
  [[nodiscard]] double fill_slots_with(const ElementView& given, const CallNow& now,
                                       const DisplacementTracker<Dim>& then, double allowed);

  /// Delivers those that are contact pairs now, in canonical order, whatever the number of workers.
  /// The elements must be in their slots; `spheres` are the same.
  void deliver_contacts(const CallNow& now, const GivenSpheres<Dim>& spheres,
                        const DisplacementTracker<Dim>& placing, base::PairSink& sink,
                        base::DetectionContext& context);

 private:
  [[nodiscard]] bool number_shifts(const DisplacementTracker<Dim>& placing,
                                   base::WorkCounter& work);
  template <class ShiftAt>
  void sift(const CandidateFilter<Dim>& test, std::size_t workers, base::PairSink& sink,
            base::DetectionContext& context, const ShiftAt& shift_at);
  void test(const CandidateFilter<Dim>& test, std::size_t workers, base::DetectionContext& context);
  template <class ShiftAt>
  void write(std::size_t workers, base::PairSink& sink, base::DetectionContext& context,
             const ShiftAt& shift_at);

  lists::FoundPairs found_;
  bool periodic_ = false;
  PairCount size_ = 0;
  std::uint64_t left_undecided_ = 0;  ///< candidates, in the last call
  CandidateLayout layout_;
  base::Array<ShiftNumber> found_shifts_;      ///< only while candidates are put in order
  base::Array<kernels::QuantumSphere> slots_;  ///< elements as they are placed now
  Quanta<Dim> quanta_;                         ///< of the slots
  base::Array<std::uint64_t> survivors_;  ///< a bit for each candidate, where the two orders differ
  std::vector<ImageShift> shift_list_;
  typename CandidateFilter<Dim>::Images images_;
};

}  // namespace abut::skin
