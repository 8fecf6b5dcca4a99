#pragma once

#include "exact/sphere.hpp"
#include "kernels/candidate_kernels.hpp"
#include "skin/elements_now.hpp"
#include "skin/quanta.hpp"

#include <abut/element_view.hpp>

#include <cstdint>
#include <span>

namespace abut::skin {

/// Spheres of an open domain as the caller gives them, their anchors, and the slots they go to.
template <int Dim>
struct FollowedElements {
  const ElementView& given;
  std::span<const exact::Sphere<Dim>> anchors;
  const Quanta<Dim>& quanta;
  std::span<kernels::QuantumSphere> slots;
  const std::uint32_t*
      slot_of;  ///< of each sphere, not in `slots` where it has none; null: its own
};

/// Reads the spheres once, and while they are in the cache measures how far each is from its anchor
/// and fills its slot. Returns what DisplacementTracker::approach() does; infinity, with slots that
/// mean nothing, also where that exceeds `allowed`, or where a sphere is invalid: to name the first
/// one is up to those who gather all.
template <int Dim>
[[nodiscard]] double follow(const FollowedElements<Dim>& elements, const CallNow& now,
                            double allowed);

}  // namespace abut::skin
