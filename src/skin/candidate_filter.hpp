#pragma once

#include "exact/lattice.hpp"
#include "kernels/candidate_kernels.hpp"
#include "skin/candidate_layout.hpp"
#include "skin/displacement_tracker.hpp"
#include "skin/elements_now.hpp"
#include "skin/given_spheres.hpp"
#include "skin/quanta.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::skin {

/// Quanta for elements as they are placed, and their images.
template <int Dim>
[[nodiscard]] Quanta<Dim> quanta_of_placed(const ElementsNow<Dim>& now,
                                           const DisplacementTracker<Dim>& placing,
                                           std::span<const ImageShift> shifts);

/// How many candidates quanta and doubles left undecided.
struct UndecidedCounts {
  std::uint64_t by_quanta = 0;
  std::uint64_t by_doubles = 0;
};

/// Tells which candidates are contact pairs, decided in quanta and floats, many at a time, then
/// exactly where these leave any in doubt.
template <int Dim>
class CandidateFilter {
 public:
  /// The candidates as they are kept from call to call.
  struct CandidateColumns {
    const CandidateLayout& layout;
    std::span<const ImageShift> shifts;  ///< those that occur between placed elements
    const ShiftNumber* shift_of;         ///< of each candidate; null in open space
  };
  using Images = std::vector<kernels::QuantumSphere>;

  /// `quanta` are those of the slots; `images` is room for one for each shift.
  CandidateFilter(const CallNow& now, const GivenSpheres<Dim>& spheres,
                  const DisplacementTracker<Dim>& placing, const CandidateColumns& candidates,
                  const Quanta<Dim>& quanta, Images& images);

  [[nodiscard]] const kernels::CandidateKernels& kernels() const noexcept { return kernels_; }

  /// A bit for each of the candidates of some words of 64: whether it is a contact pair. `slots`
  /// are the elements in quanta. Adds to `undecided`.
  void run(std::size_t first_word, std::span<std::uint64_t> survivors,
           const kernels::QuantumSphere* slots, UndecidedCounts& undecided) const;

  /// Most words of a run.
  static constexpr std::size_t words_of_run = 128;

 private:
  void fill_images();
  [[nodiscard]] std::uint64_t confirm(std::size_t first, const kernels::CandidateVerdict& verdict,
                                      UndecidedCounts& undecided) const;

  const CallNow& now_;
  const GivenSpheres<Dim>& spheres_;
  const DisplacementTracker<Dim>& placing_;
  CandidateColumns candidates_;
  exact::Lattice lattice_;
  const Quanta<Dim>& quanta_;
  Images& images_;
  kernels::CandidateKernels kernels_;
};

}  // namespace abut::skin
