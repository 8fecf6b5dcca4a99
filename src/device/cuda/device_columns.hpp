#pragma once

#include <abut/element_view.hpp>
#include <abut/pair_rule.hpp>

namespace abut::device {

/// Throws Error{wrong_usage} that names the first column which the device cannot read: one in the
/// memory of the host or of another device, null, or not aligned for its numbers.
void require_device_columns(const ElementView& spheres, int device);

/// The same for the arrays of a rule.
void require_device_arrays(const PairRule& rule, int device);

}  // namespace abut::device
