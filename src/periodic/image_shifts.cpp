// The shifts of pairs, from the lattice vectors by which their elements were moved and the image of
// the second one.

#include "lattice/check_range.hpp"
#include "periodic/images.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace abut::periodic {

template <int Dim>
void Images<Dim>::note_shifts(const lattice::CellSides<Dim>& cell, const Window& window) {
  const std::array<double, 3> shift =
      lattice::most_shifts<Dim>(*lattice_, cell, window, cells_moved_at_most_);
  std::array<std::size_t, 3> side_of_axis{2, 2, 2};
  bool as_given = true;
  for (std::size_t k = 0; k < lattice_->count; ++k) {
    const std::size_t vector = vector_of_[k];
    side_of_axis[lattice_->axis_of[vector]] = k;
    for (std::size_t l = 0; l < lattice_->count; ++l) {
      as_given = as_given && lattice_->to_given[vector][l] == (l == vector ? 1 : 0);
    }
  }
  shifts_always_fit_ = std::all_of(shift.begin(), shift.end(),
                                   [](double n) { return n < lattice::largest_bound_of_shifts; });
  side_of_axis_.reset();
  if (shifts_always_fit_ && as_given) side_of_axis_ = side_of_axis;
}

template <int Dim>
void Images<Dim>::shifts_between(std::span<const ContactPair> pairs,
                                 std::span<ImageShift> shifts) const {
  if (!moved_any_) {
    std::fill(shifts.begin(), shifts.end(), ImageShift{});
  } else if (side_of_axis_ && cells_moved_.is_packed()) {
    packed_shifts_between(pairs, shifts);
  } else {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      shifts[k] = shift_between(pairs[k].first, pairs[k].second, {});
    }
  }
}

template <int Dim>
void Images<Dim>::packed_shifts_between(std::span<const ContactPair> pairs,
                                        std::span<ImageShift> shifts) const {
  const std::uint32_t* const words = cells_moved_.words();
  const auto [x, y, z] = *side_of_axis_;
  const int bits[3] = {MovedCells::bits_of(x), MovedCells::bits_of(y), MovedCells::bits_of(z)};
  constexpr std::size_t words_fetched_ahead = 64;  // enough to hide the way to memory
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const ContactPair& later = pairs[std::min(k + words_fetched_ahead, pairs.size() - 1)];
    __builtin_prefetch(words + later.first);
    __builtin_prefetch(words + later.second);
    const std::uint32_t word =
        MovedCells::difference(words[pairs[k].first], words[pairs[k].second]);
    shifts[k] = {MovedCells::along(word, bits[0]), MovedCells::along(word, bits[1]),
                 MovedCells::along(word, bits[2])};
  }
}

template <int Dim>
lattice::ImageNumbers Images<Dim>::numbers_between(std::size_t i, std::size_t j,
                                                   const std::array<std::int32_t, 3>& image) const {
  lattice::ImageNumbers numbers{};
  for (std::size_t k = 0; k < lattice_->count; ++k) {
    std::int64_t& number = numbers[vector_of_[k]];
    number = image[k];
    if (moved_any_) number += std::int64_t{cells_moved_[i][k]} - cells_moved_[j][k];
  }
  return numbers;
}

template <int Dim>
lattice::ImageNumbers Images<Dim>::numbers_from_given(const Ghost& image) const {
  lattice::ImageNumbers numbers{};
  for (std::size_t k = 0; k < lattice_->count; ++k) {
    std::int64_t& number = numbers[vector_of_[k]];
    number = image.image[k];
    if (moved_any_) number -= cells_moved_[image.element][k];
  }
  return numbers;
}

template <int Dim>
ImageShift Images<Dim>::shift_between(std::size_t i, std::size_t j,
                                      const std::array<std::int32_t, 3>& image) const {
  if (const auto shift = lattice_->shift_of(numbers_between(i, j, image))) return *shift;
  lattice::refuse_shift(i, j);
}

template void Images<2>::note_shifts(const lattice::CellSides<2>&, const Window&);
template void Images<2>::shifts_between(std::span<const ContactPair>, std::span<ImageShift>) const;
template lattice::ImageNumbers Images<2>::numbers_between(std::size_t, std::size_t,
                                                          const std::array<std::int32_t, 3>&) const;
template lattice::ImageNumbers Images<2>::numbers_from_given(const Ghost&) const;
template ImageShift Images<2>::shift_between(std::size_t, std::size_t,
                                             const std::array<std::int32_t, 3>&) const;
template void Images<3>::note_shifts(const lattice::CellSides<3>&, const Window&);
template void Images<3>::shifts_between(std::span<const ContactPair>, std::span<ImageShift>) const;
template lattice::ImageNumbers Images<3>::numbers_between(std::size_t, std::size_t,
                                                          const std::array<std::int32_t, 3>&) const;
template lattice::ImageNumbers Images<3>::numbers_from_given(const Ghost&) const;
template ImageShift Images<3>::shift_between(std::size_t, std::size_t,
                                             const std::array<std::int32_t, 3>&) const;

}  // namespace abut::periodic
