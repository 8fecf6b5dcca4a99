#pragma once

#if defined(__FAST_MATH__)
#error \
    "abut decides contacts exactly; compile without -ffast-math (its headers refuse __FAST_MATH__)"
#endif

/// Marks what the shared library exports.
#if defined(_WIN32)
#define ABUT_API
#else
#define ABUT_API __attribute__((visibility("default")))
#endif
