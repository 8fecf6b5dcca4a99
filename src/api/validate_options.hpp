#pragma once

#include <abut/element_view.hpp>
#include <abut/options.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::api {

/// Throws Error: the first option that is out of range, or too many elements.
void validate(const Options& options, const ElementView& elements);

/// Bytes that a detection may hold in all: the caller's bound, else what the machine has.
[[nodiscard]] std::uint64_t memory_bound(const Options& options);

/// Bytes that arrays may take which follow the extent of the domain rather than the elements: the
/// caller's bound, else 1 GiB + 2 KiB per element.
[[nodiscard]] std::uint64_t grid_memory_bound(const Options& options, std::size_t element_count);

}  // namespace abut::api
