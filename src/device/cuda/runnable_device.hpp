#pragma once

namespace abut::device {

/// Throws Error{unavailable} if a device runs no kernel of this build: it is older than those that
/// the build was made for.
void require_runnable_device(int device);

}  // namespace abut::device
