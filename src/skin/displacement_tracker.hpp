#pragma once

#include "base/array.hpp"
#include "grid/bounds.hpp"
#include "lattice/lattice_frame.hpp"
#include "skin/elements_now.hpp"
#include "skin/longest_ways.hpp"

#include <abut/domain.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace abut::skin {

/// Remembers where elements were, the *anchor*, and tells how much closer than then any two of them
/// may have come. In a periodic domain elements are taken where they are modulo the lattice: it
/// *places* each by some lattice vector, so that callers who wrap positions move nothing.
template <int Dim>
class DisplacementTracker {
 public:
  using Frame = lattice::LatticeFrame<Dim>;

  explicit DisplacementTracker(base::MemoryMeter& memory);

  /// The anchor is where the elements are now. False if they cannot be followed: too many cells out
  /// of the periodic cell.
  [[nodiscard]] bool start(const ElementsNow<Dim>& now);

  /// The elements have other numbers now, some are gone and some are new: element i was
  /// `before[i]`, or, if that is ElementIds::none, is new and has its anchor where it is.
  void renumber(const ElementsNow<Dim>& now, std::span<const std::uint32_t> before);

  /// Forgets the anchor.
  void stop() noexcept { started_ = false; }

  /// Upper bound of what the distance of two elements, less their radii, may have shrunk by since
  /// the start; infinite where nothing can be told or it clearly exceeds `allowed`. Throws as a
  /// detection does when the lattice is no lattice.
  [[nodiscard]] double approach(const ElementsNow<Dim>& now, double allowed);

  /// Places of the elements when they were anchored; domain_then() is the domain of that call.
  [[nodiscard]] std::span<const exact::Sphere<Dim>> anchors() const noexcept {
    return {anchor_.data(), size_};
  }
  [[nodiscard]] const Domain& domain_then() const noexcept { return domain_then_; }

  /// True if there are anchors of so many elements, now and then in open space.
  [[nodiscard]] bool anchored_in_open_space(std::size_t elements,
                                            const Domain& domain) const noexcept {
    return started_ && elements == size_ && !domain.is_periodic() && !domain_then_.is_periodic();
  }
  /// A box around all anchors in open space, and bounds of their radii.
  [[nodiscard]] const grid::Bounds<Dim>& anchor_bounds() const noexcept { return anchor_bounds_; }

  /// The elements as placed in the last call; without a periodic domain those of the caller.
  [[nodiscard]] std::span<const exact::Sphere<Dim>> placed() const noexcept { return placed_; }

  /// Number of lattice vectors that were taken off when element i was placed.
  [[nodiscard]] const lattice::CellNumbers& cells(std::size_t i) const noexcept {
    return cells_[i];
  }

  /// True if any such number of the element is not 0. Cheaper than reading the numbers, which lie
  /// farther apart in memory.
  [[nodiscard]] bool moved(std::size_t i) const noexcept { return moved_[i] != 0; }

  /// The image shift of a pair of elements as given, from that of the placed ones.
  [[nodiscard]] ImageShift shift_as_given(const ContactPair& pair,
                                          const ImageShift& placed) const noexcept {
    if (!any_moved_ || (!moved(pair.first) && !moved(pair.second))) return placed;
    const lattice::CellNumbers& first = cells(pair.first);
    const lattice::CellNumbers& second = cells(pair.second);
    return {placed.x + first[0] - second[0], placed.y + first[1] - second[1],
            placed.z + first[2] - second[2]};
  }

  /// Sum of the amounts of all numbers from which an element was placed, at most.
  [[nodiscard]] double magnitude() const noexcept { return magnitude_; }

  /// Mean radius of the elements at the start.
  [[nodiscard]] double mean_radius() const noexcept { return mean_radius_; }

 private:
  /// Longest ways and largest numbers among the elements of one worker.
  struct alignas(128) Part {
    LongestWays ways;
    double growth = 0.0;     ///< largest
    double magnitude = 0.0;  ///< of moved elements
    double radii = 0.0;
    bool moved = false;  ///< whether any is moved
    std::array<double, Dim> lower{};
    std::array<double, Dim> upper{};

    void include(const Part& others) noexcept;
  };

  void start_in_cell(const ElementsNow<Dim>& now);
  [[nodiscard]] Part measure(const ElementsNow<Dim>& now, double allowed);
  void measure_open(const ElementsNow<Dim>& now, std::size_t first, std::size_t last,
                    Part& part) const;
  void measure_periodic(const ElementsNow<Dim>& now, double allowed, std::size_t first,
                        std::size_t last, Part& part);
  [[nodiscard]] bool comparable(const ElementsNow<Dim>& now) const noexcept;
  void follow_lattice(const Domain& domain);
  [[nodiscard]] lattice::CellNumbers cells_around_middle(const Frame& frame,
                                                         const double* position) const;
  void include_fractions(const exact::Sphere<Dim>& anchor, Part& part) const;
  void derive_spread();

  base::Array<exact::Sphere<Dim>> anchor_;
  base::Array<exact::Sphere<Dim>> next_anchor_;  ///< only while elements are renumbered
  base::Array<exact::Sphere<Dim>> own_placed_;
  base::Array<lattice::CellNumbers> cells_;
  base::Array<lattice::CellNumbers> next_cells_;  ///< likewise
  base::Array<std::uint8_t> moved_;
  std::span<const exact::Sphere<Dim>> placed_;
  std::vector<Part> parts_;

  bool started_ = false;
  bool any_moved_ = false;
  std::size_t size_ = 0;
  grid::Bounds<Dim> anchor_bounds_;
  Domain domain_then_ = Domain::open();
  Domain domain_now_ = Domain::open();
  std::optional<Frame> then_;
  std::optional<Frame> now_;
  std::array<double, Dim> middle_{};  ///< fractions of the middle of all elements at the start
  Part anchored_;                     ///< fractions of the anchors
  std::array<double, Dim> spread_{};  ///< how far these are apart
  double magnitude_then_ = 0.0;
  double magnitude_ = 0.0;
  double mean_radius_ = 0.0;
};

}  // namespace abut::skin
