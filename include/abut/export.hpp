#pragma once

#if __cplusplus < 202002L
// A file that is not there ends the compilation; whatever followed would only hide the reason.
#include <abut needs C++20: compile with -std=c++20>
#endif

/// Marks what the shared library exports.
#if defined(_WIN32)
#define ABUT_API
#else
#define ABUT_API __attribute__((visibility("default")))
#endif
