#pragma once

#include <abut/export.hpp>

#include <string>
#include <string_view>

#define ABUT_VERSION_MAJOR 0  ///< first number of the version of these headers
#define ABUT_VERSION_MINOR 1  ///< second number
#define ABUT_VERSION_PATCH 0  ///< third number

namespace abut {

/// Returns the version of the library that is linked, such as "0.1.0".
[[nodiscard]] ABUT_API std::string_view version();

/// Describes how the linked library was built, in one line: version, compiler, architecture,
/// features.
[[nodiscard]] ABUT_API std::string build_description();

}  // namespace abut
