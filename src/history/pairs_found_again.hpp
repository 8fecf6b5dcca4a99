#pragma once

#include "history/carried_pairs.hpp"

#include <abut/contact_history.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace abut::history {

/// The pairs of a step and their shifts; without shifts all are alike.
struct PairsOfStep {
  std::span<const ContactPair> pairs;
  std::span<const ImageShift> shifts;
  std::size_t elements;  ///< that they were found for
};

/// Finds the pairs of a step among those of the one before. All workers take parts of the list;
/// what they find does not depend on their number.
class PairsFoundAgain {
 public:
  using Run = detail::ContactMatcher::Run;

  /// Throws Error{wrong_usage} for pairs that do not ascend or are not of these elements. Then, and
  /// where memory runs out, nothing is known of the pairs.
  void find(const PairsOfStep& now, const CarriedPairs& before, std::size_t workers);

  /// Pairs in a row that both steps have.
  [[nodiscard]] std::span<const Run> runs() const noexcept { return all_.runs; }
  /// Places, in the step before, of pairs that are no more.
  [[nodiscard]] std::span<const PairCount> lost() const noexcept { return all_.lost; }

  /// Hands over the places of pairs that are new, and of those whose elements have changed places,
  /// for the memory of older ones.
  void swap_places(std::vector<PairCount>& born, std::vector<PairCount>& flipped) noexcept {
    all_.born.swap(born);
    all_.flipped.swap(flipped);
  }

 private:
  struct PairsOfWorker {
    std::vector<Run> runs;
    std::vector<PairCount> born;     ///< places in the list
    std::vector<PairCount> flipped;  ///< the same
    std::vector<PairCount> lost;     ///< places in the list of the step before

    void clear() noexcept;
    void append(const PairsOfWorker& next);
  };

  template <bool WithShifts>
  class Merge;

  template <bool WithShifts>
  void find_in(const Merge<WithShifts>& lists, std::size_t workers);

  PairsOfWorker all_;
  std::vector<PairsOfWorker> parts_;  ///< of each worker but the first
};

}  // namespace abut::history
