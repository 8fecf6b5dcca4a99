#pragma once

#include <abut/export.hpp>

#include <span>
#include <string_view>

namespace abut {

/// Instruction sets that the kernels of `rows` are built for. All give the same bytes; they differ
/// in time.
enum class Simd {
  automatic,  ///< named "auto": the widest that this processor runs
  scalar,     ///< plain C++
  sse4,       ///< x86 with SSE 4
  avx2,       ///< x86 with AVX2
  avx512,     ///< x86 with AVX-512
  neon,       ///< ARM with NEON
};

/// Environment variable that forces a level where Options::simd is automatic.
inline constexpr const char* simd_variable = "ABUT_SIMD";

/// Lists all levels but `automatic`, narrowest first.
[[nodiscard]] ABUT_API std::span<const Simd> simd_levels();

/// True if the level is built in and this processor runs it.
[[nodiscard]] ABUT_API bool available(Simd level);

/// Returns the name of a level, "auto" for `automatic`.
[[nodiscard]] ABUT_API std::string_view name_of(Simd level);

/// Returns the level of that name, "auto" included. Throws Error{wrong_usage} for an unknown name;
/// the message lists the known ones.
[[nodiscard]] ABUT_API Simd simd_named(std::string_view name);

}  // namespace abut
