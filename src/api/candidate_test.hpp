#pragma once

#include "api/displacement.hpp"
#include "api/snapshot.hpp"
#include "base/lattice.hpp"
#include "base/periodic_predicate.hpp"
#include "base/sphere_predicate.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::api {

/// Few enough for numbers of 16 bits and for the first cache.
inline constexpr std::size_t candidates_of_block = 512;

/// Which of a block of candidates are contact pairs: their places in the block.
struct Survivors {
  std::array<std::uint16_t, candidates_of_block> places;
  std::size_t count = 0;
};

/// Decides candidates of open space: in doubles without branches, then exactly where the band of
/// base::within_reach leaves any in doubt.
template <int Dim>
class OpenCandidateTest {
 public:
  explicit OpenCandidateTest(const Snapshot<Dim>& now);

  /// Adds one to `exact_decisions` for each that doubles cannot decide.
  void run(std::span<const ContactPair> candidates, Survivors& survivors,
           std::uint64_t& exact_decisions) const;

 private:
  std::span<const base::Sphere<Dim>> spheres_;
  double margin_;
  bool in_range_;  ///< all squares that may occur
};

/// The same among placed elements: `shifts` lists the image shifts between them that occur.
template <int Dim>
class PeriodicCandidateTest {
 public:
  using Images = std::vector<std::array<double, Dim>>;

  /// `images` is room for one vector for each shift.
  PeriodicCandidateTest(const Snapshot<Dim>& now, const Displacement<Dim>& placing,
                        std::span<const ImageShift> shifts, Images& images);

  void run(std::span<const ContactPair> candidates, const std::uint16_t* shift_of,
           Survivors& survivors, std::uint64_t& exact_decisions) const;

  /// The shift of a pair of the elements as given.
  [[nodiscard]] ImageShift shift_of(ContactPair pair, std::uint16_t number) const noexcept {
    const ImageShift& shift = shifts_[number];
    if (!placing_.moved(pair.first) && !placing_.moved(pair.second)) return shift;
    const CellNumbers& first = placing_.cells(pair.first);
    const CellNumbers& second = placing_.cells(pair.second);
    return {shift.x + first[0] - second[0], shift.y + first[1] - second[1],
            shift.z + first[2] - second[2]};
  }

 private:
  std::span<const base::Sphere<Dim>> spheres_;
  std::span<const base::Sphere<Dim>> placed_;
  const Displacement<Dim>& placing_;
  std::span<const ImageShift> shifts_;
  base::Lattice lattice_;
  const Images& images_;  ///< shift times lattice
  double margin_;
  double slack_ = 0.0;
  bool in_range_ = false;
};

}  // namespace abut::api
