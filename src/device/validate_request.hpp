#pragma once

#include "device/backend.hpp"

#include <abut/domain.hpp>
#include <abut/options.hpp>

namespace abut::device {

/// Throws Error for what a device does not do yet (wrong_usage, with what to take instead), for an
/// option out of range, and for too many elements.
void validate_request(const Options& options, const SphereSets& spheres, const Domain& domain);

}  // namespace abut::device
