#pragma once

#include <abut/export.hpp>

#include <string>
#include <string_view>

#define ABUT_VERSION_MAJOR 0
#define ABUT_VERSION_MINOR 1
#define ABUT_VERSION_PATCH 0

namespace abut {

/// Version of the library that is linked, "0.1.0".
[[nodiscard]] ABUT_API std::string_view version();

/// How the linked library was built, in one line: version, compiler, architecture, features.
[[nodiscard]] ABUT_API std::string build_description();

}  // namespace abut
