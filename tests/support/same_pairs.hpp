#pragma once

#include "support/oracle.hpp"

#include <gtest/gtest.h>

#include <span>

namespace abut::testing {

/// Whether `found`, in whatever order, holds each pair of `expected` (canonical order) exactly once
/// and nothing else. Says which pairs are missing, wrong or repeated.
[[nodiscard]] ::testing::AssertionResult same_pairs(std::span<const ContactPair> expected,
                                                    std::span<const ContactPair> found);

/// The same, and `found` itself ascends.
[[nodiscard]] ::testing::AssertionResult same_canonical_pairs(std::span<const ContactPair> expected,
                                                              std::span<const ContactPair> found);

}  // namespace abut::testing
