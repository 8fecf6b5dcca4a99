#pragma once

#include <abut/export.hpp>

#include <span>
#include <string_view>

namespace abut {

/// Instruction sets that the kernels of `rows` are built for. All give the same bytes; they differ
/// in time.
enum class Simd {
  automatic,  ///< named "auto": the widest that this processor runs
  scalar,
  sse4,
  avx2,
  avx512,
  neon,
};

/// Environment variable that forces a level where Options::simd is automatic.
inline constexpr const char* simd_variable = "ABUT_SIMD";

/// All levels but `automatic`, narrowest first.
[[nodiscard]] ABUT_API std::span<const Simd> simd_levels();

/// Whether the level is built in and this processor runs it.
[[nodiscard]] ABUT_API bool available(Simd level);

[[nodiscard]] ABUT_API std::string_view name_of(Simd level);

/// The level of that name, "auto" included. Throws Error{wrong_usage} naming those there are.
[[nodiscard]] ABUT_API Simd simd_named(std::string_view name);

}  // namespace abut
