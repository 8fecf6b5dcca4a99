#pragma once

#include <abut/domain.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>

#include <cstddef>
#include <span>

namespace abut::geometry {

/// Throws Error{wrong_usage} unless each array of shifts and quantities is empty or has `count`
/// entries; `of_what` names what they belong to.
void require_lengths(std::size_t count, const char* of_what, std::span<const ImageShift> shifts,
                     const PairGeometrySpans& geometry);

/// Throws Error{wrong_usage} unless `count` pairs or contacts have the shifts that their domain
/// wants.
void require_shifts(std::size_t count, const char* of_what, std::span<const ImageShift> shifts,
                    const Domain& domain);

/// Arrays of `count` entries for the quantities that are wanted.
[[nodiscard]] PairGeometry arrays_for(std::size_t count, Quantities wanted);

/// The quantities whose arrays are not empty.
[[nodiscard]] Quantities wanted_by(const PairGeometrySpans& geometry) noexcept;

}  // namespace abut::geometry
