// Direct checking in a periodic domain: every element against every image of every other.
//
// Which images: x_i - x_j = t_1 b_1 + t_2 b_2 + t_3 b_3 in a reduced basis b of the lattice. The
// image moved by m_1 b_1 + m_2 b_2 + m_3 b_3 lies |t_k - m_k| h_k or farther away along the
// perpendicular height h_k of the cell, so within a reach R only whole numbers m_k from
// t_k - R / h_k to t_k + R / h_k count. Of boxes the same with their centers, and a reach on each
// axis. The exact test decides among them.

#include "reference/direct_check_images.hpp"

#include "base/opposite_shift.hpp"
#include "lattice/check_range.hpp"
#include "lattice/image_decider.hpp"
#include "lattice/image_window.hpp"
#include "lattice/reduced_lattice.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::reference {
namespace {

template <int Dim>
class Checker {
 public:
  Checker(const exact::Elements<Dim>& elements, const exact::Lattice& lattice, double margin,
          base::ImagePairWriter& pairs, base::DetectionContext& context)
      : elements_(elements),
        reduced_(lattice),
        windows_(reduced_),
        decider_(elements, lattice, reduced_, 1.0, margin),
        margin_(margin),
        pairs_(pairs),
        context_(context) {
    lattice::check_range_as_given<Dim>(elements.spheres, lattice, margin,
                                       elements.are_boxes() ? Shape::box : Shape::sphere);
  }

  void check(std::size_t i, std::size_t j) {
    count_step();
    lattice::ImageWindow window = window_of(i, j);
    if (window.is_empty()) return;
    lattice::require_narrow_window(window.farthest());
    const lattice::ImageNumbers middle = window.middle();
    if (i == j) window.first[0] = 0;
    lattice::for_each_image(window, middle, [&](const lattice::ImageNumbers& numbers) {
      count_step();
      // Of (i, i, n) and (i, i, -n) one is a pair: look at one of them, name the positive one.
      if (i == j && numbers <= lattice::ImageNumbers{}) return;
      ++context_.candidate_tests;
      std::optional<ImageShift> shift =
          decider_.shift_within_reach(i, j, numbers, context_.exact_decisions);
      if (!shift) return;
      if (i == j && *shift < ImageShift{}) shift = base::opposite(*shift);
      pairs_.push({static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)}, *shift);
    });
  }

 private:
  static constexpr std::uint64_t steps_between_polls = 1 << 18;

  void count_step() {
    if (++steps_ % steps_between_polls == 0) context_.progress.poll();
  }

  [[nodiscard]] lattice::ImageWindow window_of(std::size_t i, std::size_t j) const noexcept {
    const auto& [spheres, boxes] = elements_;
    return elements_.are_boxes() ? windows_.of(boxes[i], boxes[j], margin_)
                                 : windows_.of(spheres[i], spheres[j], margin_);
  }

  exact::Elements<Dim> elements_;
  lattice::ReducedLattice<Dim> reduced_;
  lattice::ImageWindows<Dim> windows_;
  lattice::ImageDecider<Dim> decider_;
  double margin_;
  base::ImagePairWriter& pairs_;
  base::DetectionContext& context_;
  std::uint64_t steps_ = 0;  ///< pairs and images looked at
};

}  // namespace

template <int Dim>
void direct_check_images(const exact::Elements<Dim>& elements, const exact::Lattice& lattice,
                         double margin, base::ImagePairWriter& pairs,
                         base::DetectionContext& context) {
  Checker<Dim> checker(elements, lattice, margin, pairs, context);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    context.progress.at(i);
    for (std::size_t j = i; j < elements.size(); ++j) checker.check(i, j);
  }
}

template void direct_check_images(const exact::Elements<2>&, const exact::Lattice&, double,
                                  base::ImagePairWriter&, base::DetectionContext&);
template void direct_check_images(const exact::Elements<3>&, const exact::Lattice&, double,
                                  base::ImagePairWriter&, base::DetectionContext&);

}  // namespace abut::reference
