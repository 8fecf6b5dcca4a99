#pragma once

#include <abut/simd.hpp>

namespace abut::kernels {

/// The level to run: the one asked for; else the one in the environment; else the widest there is.
/// Throws Error{unavailable} where it cannot run here, Error{wrong_usage} where the environment
/// names none.
[[nodiscard]] Simd level_to_run(Simd asked);

}  // namespace abut::kernels
