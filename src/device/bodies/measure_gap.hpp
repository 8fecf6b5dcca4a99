#pragma once

#include "base/host_device.hpp"
#include "device/bodies/filter.hpp"
#include "device/bodies/joined_columns.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "exact/box.hpp"
#include "exact/lattice.hpp"
#include "exact/periodic_box-inl.hpp"
#include "exact/periodic_gap-inl.hpp"
#include "exact/periodic_predicate-inl.hpp"
#include "exact/sphere_gap-inl.hpp"
#include "exact/sphere_predicate-inl.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace abut::device {

/// Pairs of elements whose gaps are measured, with the numbers that the caller knows them by.
template <class Given>
struct MeasuredPairs {
  Given elements;
  exact::Lattice lattice;
  const ContactPair* pairs;
  const ImageShift* shifts;  ///< null in open space
  bool all_touch;            ///< whether each is known to touch: there was no margin
  double* gaps;
};

/// A gap that only the last stages can tell.
inline constexpr double open_gap = std::numeric_limits<double>::quiet_NaN();

/// Whether two spheres touch, by the filter and the first two exact stages.
template <int Dim>
[[nodiscard]] ABUT_HD inline std::optional<bool> touch_by_first_stages(
    const exact::Sphere<Dim>& a, const exact::Sphere<Dim>& b) noexcept {
  const FilterVerdict verdict = filter(a, b, 0.0, 0.0);
  if (verdict != FilterVerdict::doubtful) return verdict == FilterVerdict::within;
  if (const auto decided = exact::decide_if_nothing_rounded(a, b, 0.0)) return decided;
  return exact::decide_in_double_double(a, b, 0.0);
}

/// The gap of two elements in open space, or `open_gap`. That of boxes has no later stages.
template <int Dim>
[[nodiscard]] ABUT_HD inline double gap_by_first_stages(const exact::Box<Dim>& a,
                                                        const exact::Box<Dim>& b, bool) noexcept {
  return exact::gap(a, b);
}
template <int Dim>
[[nodiscard]] ABUT_HD inline double gap_by_first_stages(const exact::Sphere<Dim>& a,
                                                        const exact::Sphere<Dim>& b,
                                                        bool touch_for_certain) noexcept {
  std::optional<bool> touch = true;
  if (!touch_for_certain) touch = touch_by_first_stages(a, b);
  return touch ? exact::gap_of_sign(exact::computed_gap(a, b), *touch) : open_gap;
}

/// Body: the gap of pair k, as far as the first stages tell it; nothing of an image, whose steps
/// along lattice vectors take memory of a thread.
template <class Given>
struct MeasureGap {
  MeasuredPairs<Given> measured;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const ContactPair pair = measured.pairs[k];
    measured.gaps[k] =
        is_of_image(k) ? open_gap
                       : gap_by_first_stages(measured.elements.first_of(pair),
                                             measured.elements.second_of(pair), measured.all_touch);
  }

 private:
  [[nodiscard]] ABUT_HD bool is_of_image(std::uint64_t k) const noexcept {
    if (measured.shifts == nullptr) return false;
    const ImageShift shift = measured.shifts[k];
    return shift.x != 0 || shift.y != 0 || shift.z != 0;
  }
};

/// Body: the gap of pair k, if it is open still, by all stages.
template <class Given>
struct MeasureOpenGap {
  MeasuredPairs<Given> measured;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    if (!std::isnan(measured.gaps[k])) return;
    const ContactPair pair = measured.pairs[k];
    const auto a = measured.elements.first_of(pair);
    const auto b = measured.elements.second_of(pair);
    const ImageShift shift = measured.shifts == nullptr ? ImageShift{} : measured.shifts[k];
    measured.gaps[k] = exact::gap(a, b, shift, measured.lattice);
  }
};

}  // namespace abut::device
