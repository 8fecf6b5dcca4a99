#pragma once

#include "base/host_device.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "exact/exact_stages.hpp"
#include "exact/sphere_predicate-inl.hpp"

#include <abut/pair.hpp>

#include <cstdint>
#include <optional>

namespace abut::device {

// Doubtful pairs are decided in place, on the caller's numbers. A pair has first < second; one that
// stays open after the first stages is turned round, and one that is apart has first == second.

/// Body: the first two exact stages, which need no memory. They decide nearly all.
template <int Dim, class T>
struct DecideMost {
  SphereColumns<Dim, T> elements;
  double margin;
  ContactPair* pairs;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const ContactPair pair = pairs[k];
    const exact::Sphere<Dim> a = elements[pair.first];
    const exact::Sphere<Dim> b = elements[pair.second];
    std::optional<bool> decided = exact::decide_if_nothing_rounded(a, b, margin);
    if (!decided) decided = exact::decide_in_double_double(a, b, margin);
    if (!decided) {
      pairs[k] = {pair.second, pair.first};
    } else if (!*decided) {
      pairs[k] = {0, 0};
    }
  }
};

/// Body: the last two stages, for the pairs that were turned round.
template <int Dim, class T>
struct DecideOpen {
  SphereColumns<Dim, T> elements;
  double margin;
  ContactPair* pairs;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const ContactPair pair = pairs[k];
    if (pair.first <= pair.second) return;
    const exact::Sphere<Dim> a = elements[pair.second];
    const exact::Sphere<Dim> b = elements[pair.first];
    const std::optional<bool> scaled = exact::decide_scaled(a, b, margin);
    const bool within = scaled ? *scaled : exact::decide_accumulated(a, b, margin);
    pairs[k] = within ? ContactPair{pair.second, pair.first} : ContactPair{0, 0};
  }
};

/// Body: copies pair k.
struct CopyPair {
  const ContactPair* from;
  ContactPair* to;

  ABUT_HD void operator()(std::uint64_t k) const noexcept { to[k] = from[k]; }
};

/// Whether a decided pair is a contact pair.
struct ContactTester {
  [[nodiscard]] ABUT_HD bool operator()(const ContactPair& pair) const noexcept {
    return pair.first != pair.second;
  }
};

}  // namespace abut::device
