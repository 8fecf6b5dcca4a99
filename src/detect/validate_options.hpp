#pragma once

#include "elements/require_dimensions.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/options.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::detect {

using elements::require_dimensions;

using elements::require_alike;

/// Throws Error: the first option that is out of range, a domain that the elements do not live in
/// or the algorithm does not support, or too many elements.
void validate(const Options& options, const ElementView& elements, const Domain& domain);

/// Checks a call with two sets, which must have the same number of dimensions.
void validate(const Options& options, const ElementView& first, const ElementView& second,
              const Domain& domain);

/// Throws Error for a number of threads that is negative.
void require_threads(const Options& options);

/// Throws Error for a cutoff that is not a length and for elements that have a radius.
void require_points(const ElementView& points, double cutoff);

/// Bytes that a detection may hold in all: the caller's bound, else what the machine has.
[[nodiscard]] std::uint64_t memory_bound(const Options& options);

/// Bytes that arrays may take which follow the extent of the domain rather than the elements: the
/// caller's bound, else 1 GiB + 2 KiB per element.
[[nodiscard]] std::uint64_t grid_memory_bound(const Options& options, std::size_t element_count);

}  // namespace abut::detect
