#pragma once

#include "base/host_device.hpp"
#include "device/bodies/apart_pair.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "exact/box.hpp"
#include "exact/exact_stages.hpp"
#include "exact/sphere_predicate-inl.hpp"

#include <abut/pair.hpp>

#include <cstdint>
#include <optional>

namespace abut::device {

// Doubtful pairs are decided in place, on the caller's numbers. A pair has first < second; one that
// stays open after the first stages is turned round, and one that is apart becomes apart_pair.

/// The stages that need no memory of a thread: the first two of spheres; all of boxes.
template <int Dim>
[[nodiscard]] ABUT_HD inline std::optional<bool> decide_first(const exact::Sphere<Dim>& a,
                                                              const exact::Sphere<Dim>& b,
                                                              double margin) noexcept {
  if (const auto decided = exact::decide_if_nothing_rounded(a, b, margin)) return decided;
  return exact::decide_in_double_double(a, b, margin);
}
template <int Dim>
[[nodiscard]] ABUT_HD inline std::optional<bool> decide_first(const exact::Box<Dim>& a,
                                                              const exact::Box<Dim>& b,
                                                              double margin) noexcept {
  std::uint64_t exact_decisions = 0;
  return exact::within_reach(a, b, margin, exact_decisions);
}

/// Body: the first exact stages, which need no memory. They decide nearly all pairs that no
/// periodic face lies between.
template <class Spheres>
struct DecideMost {
  Spheres elements;
  double margin;
  ContactPair* pairs;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const ContactPair pair = pairs[k];
    std::optional<bool> decided;
    if (elements.is_as_given(pair)) {
      decided = decide_first(elements.given().whole(pair.first),
                             elements.given().whole(pair.second), margin);
    }
    if (!decided) {
      pairs[k] = {pair.second, pair.first};
    } else if (!*decided) {
      pairs[k] = apart_pair();
    }
  }
};

/// The last two stages.
template <int Dim, class T>
[[nodiscard]] ABUT_HD std::optional<bool> decide_at_last(const SphereColumns<Dim, T>& elements,
                                                         const ContactPair& pair,
                                                         double margin) noexcept {
  const exact::Sphere<Dim> a = elements[pair.first];
  const exact::Sphere<Dim> b = elements[pair.second];
  if (const std::optional<bool> scaled = exact::decide_scaled(a, b, margin)) return scaled;
  return exact::decide_accumulated(a, b, margin);
}

/// Body: the last stages, for the pairs that were turned round. Those that cannot be told, a pair
/// across too many periodic cells, stay so.
template <class Spheres>
struct DecideOpen {
  Spheres elements;
  double margin;
  ContactPair* pairs;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const ContactPair pair = pairs[k];
    if (pair.first <= pair.second) return;
    const ContactPair asked{pair.second, pair.first};
    const std::optional<bool> within = decide_at_last(elements, asked, margin);
    if (within) pairs[k] = *within ? asked : apart_pair();
  }
};

/// Body of a reduction: the elements of a pair that stayed open, the first one in the upper half;
/// else those of none.
template <class Spheres>
struct ElementsOfOpenPair {
  static constexpr std::uint64_t none = ~std::uint64_t{0};

  Spheres elements;
  const ContactPair* pairs;

  [[nodiscard]] ABUT_HD std::uint64_t operator()(std::uint64_t k) const noexcept {
    const ContactPair pair = pairs[k];
    if (pair.first <= pair.second) return none;
    const std::uint64_t one = pair.second;
    const std::uint64_t other = elements.element_of(pair.first);
    return one < other ? one << 32 | other : other << 32 | one;
  }
};

/// Body of a reduction: 1 if a decided pair is a contact pair, else 0.
struct ContactOfPair {
  const ContactPair* pairs;

  [[nodiscard]] ABUT_HD std::uint64_t operator()(std::uint64_t k) const noexcept {
    return is_apart(pairs[k]) ? 0 : 1;
  }
};

}  // namespace abut::device
