// Direct checking in a periodic domain: every element against every image of every other.
//
// Which images: x_i - x_j = t_1 b_1 + t_2 b_2 + t_3 b_3 in a reduced basis b of the lattice. The
// image moved by m_1 b_1 + m_2 b_2 + m_3 b_3 lies |t_k - m_k| h_k or farther away along the
// perpendicular height h_k of the cell, so within a reach R only whole numbers m_k from
// t_k - R / h_k to t_k + R / h_k count. Of boxes the same with their centers, and a reach on each
// axis. The exact test decides among them.

#include "reference/direct_check_images.hpp"

#include "lattice/check_range.hpp"
#include "lattice/reduced_lattice.hpp"
#include "reference/image_window.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::reference {
namespace {

ImageShift opposite(const ImageShift& shift) noexcept {
  return {-shift.x, -shift.y, -shift.z};
}

template <int Dim>
class Checker {
 public:
  Checker(const base::Elements<Dim>& elements, const base::Lattice& lattice, double margin,
          base::ImagePairWriter& pairs, base::DetectionContext& context)
      : elements_(elements),
        lattice_(lattice),
        reduced_(lattice),
        margin_(margin),
        pairs_(pairs),
        context_(context) {
    const Shape shape = elements.are_boxes() ? Shape::box : Shape::sphere;
    grid::check_range<Dim>(elements.spheres, reduced_, margin, shape);
  }

  void check(std::size_t i, std::size_t j) {
    if (++windows_ % steps_between_polls == 0) context_.progress.poll();
    ImageWindow window = window_of(i, j);
    if (window.is_empty()) return;
    if (i == j) window.first[0] = 0;
    for_each_image(window, [&](const grid::ImageNumbers& numbers) {
      // Of (i, i, n) and (i, i, -n) one is a pair: look at one of them, name the positive one.
      if (i == j && numbers <= grid::ImageNumbers{}) return;
      if (++context_.candidate_tests % steps_between_polls == 0) context_.progress.poll();
      std::optional<ImageShift> shift = reduced_.shift_of(numbers);
      if (!shift) grid::refuse_shift(i, j);
      if (!elements_.within_reach(i, j, *shift, lattice_, margin_, context_.exact_decisions)) {
        return;
      }
      if (i == j && *shift < ImageShift{}) shift = opposite(*shift);
      pairs_.push({static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)}, *shift);
    });
  }

 private:
  static constexpr std::uint64_t steps_between_polls = 1 << 18;

  [[nodiscard]] ImageWindow window_of(std::size_t i, std::size_t j) const noexcept {
    const auto& [spheres, boxes] = elements_;
    return elements_.are_boxes() ? image_window(reduced_, boxes[i], boxes[j], margin_)
                                 : image_window(reduced_, spheres[i], spheres[j], margin_);
  }

  base::Elements<Dim> elements_;
  const base::Lattice& lattice_;
  grid::ReducedLattice<Dim> reduced_;
  double margin_;
  base::ImagePairWriter& pairs_;
  base::DetectionContext& context_;
  std::uint64_t windows_ = 0;
};

}  // namespace

template <int Dim>
void direct_check_images(const base::Elements<Dim>& elements, const base::Lattice& lattice,
                         double margin, base::ImagePairWriter& pairs,
                         base::DetectionContext& context) {
  Checker<Dim> checker(elements, lattice, margin, pairs, context);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    context.progress.at(i);
    for (std::size_t j = i; j < elements.size(); ++j) checker.check(i, j);
  }
}

template void direct_check_images(const base::Elements<2>&, const base::Lattice&, double,
                                  base::ImagePairWriter&, base::DetectionContext&);
template void direct_check_images(const base::Elements<3>&, const base::Lattice&, double,
                                  base::ImagePairWriter&, base::DetectionContext&);

}  // namespace abut::reference
