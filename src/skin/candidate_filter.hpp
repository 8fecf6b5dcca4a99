#pragma once

#include "exact/lattice.hpp"
#include "kernels/candidate_kernels.hpp"
#include "skin/candidate_layout.hpp"
#include "skin/displacement_tracker.hpp"
#include "skin/elements_now.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::skin {

/// Lengths in whole quanta, so small that all that is compared fits into 32 bits
/// (docs/derivations/skin.md).
template <int Dim>
class Quanta {
 public:
  /// Chooses quanta for elements as they are placed; `farthest_image` is the most that an image
  /// shift adds to a coordinate.
  Quanta(const ElementsNow<Dim>& now, const DisplacementTracker<Dim>& placing,
         double farthest_image);

  /// True if there are such quanta; there are none if numbers are extreme.
  [[nodiscard]] bool fit() const noexcept { return per_length_ > 0.0; }

  /// slots[k] = the sphere of number numbers[k], or sphere k where `numbers` is null.
  void fill(const exact::Sphere<Dim>* spheres, const ElementIndex* numbers,
            std::span<kernels::QuantumSphere> slots) const;

  [[nodiscard]] kernels::QuantumSphere of(const exact::Sphere<Dim>& sphere) const noexcept {
    kernels::QuantumSphere result{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      result.center[axis] = whole(sphere.center[axis] - middle_[axis]);
    }
    result.radius = whole(sphere.radius);
    return result;
  }

  /// Rounded towards zero. What is too large is so by a rounding, or is of no account.
  [[nodiscard]] std::int32_t whole(double length) const noexcept {
    const double quanta = length * per_length_;
    return static_cast<std::int32_t>(std::min(most, std::max(-most, quanta)));
  }

 private:
  static constexpr double most = 0x1p29;

  kernels::CandidateKernels kernels_;
  std::array<double, Dim> middle_{};
  double per_length_ = 0.0;
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

  /// `images` is room for one for each shift.
  CandidateFilter(const ElementsNow<Dim>& now, const DisplacementTracker<Dim>& placing,
                  const CandidateColumns& candidates, Images& images);

  [[nodiscard]] const Quanta<Dim>& quanta() const noexcept { return quanta_; }

  /// A bit for each of the candidates of some words of 64: whether it is a contact pair. `slots`
  /// are the elements in quanta. Adds one to `exact_decisions` for each that doubles cannot decide.
  void run(std::size_t first_word, std::span<std::uint64_t> survivors,
           const kernels::QuantumSphere* slots, std::uint64_t& exact_decisions) const;

  /// Most words of a run.
  static constexpr std::size_t words_of_run = 128;

 private:
  void fill_images();
  [[nodiscard]] std::uint64_t confirm(std::size_t first, const kernels::CandidateVerdict& verdict,
                                      std::uint64_t& exact_decisions) const;

  const ElementsNow<Dim>& now_;
  const DisplacementTracker<Dim>& placing_;
  CandidateColumns candidates_;
  exact::Lattice lattice_;
  Images& images_;
  kernels::CandidateKernels kernels_;
  Quanta<Dim> quanta_;
};

}  // namespace abut::skin
