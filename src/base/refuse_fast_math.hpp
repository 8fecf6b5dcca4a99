#pragma once

// The library decides in floating point as the standard has it. Public headers decide nothing, so
// that callers may compile as they like.
#if defined(__FAST_MATH__)
#error "abut decides contacts exactly: build the library without -ffast-math and -Ofast"
#endif
