#pragma once

#include "support/oracle.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/pair_list.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {

/// The levels that this processor runs, scalar first.
[[nodiscard]] std::vector<Simd> simd_levels_here();

/// One line for a test's output: which levels were run, and which this processor or build lacks.
[[nodiscard]] std::string told_simd_levels();

/// `rows` gives the expected pairs (canonical order) from every level available here with each
/// number of threads, and in `as_found` order the same bytes after as many candidate tests and
/// exact decisions from all of them.
[[nodiscard]] ::testing::AssertionResult rows_agree(std::span<const ContactPair> expected,
                                                    const ElementView& elements, double margin,
                                                    std::initializer_list<int> threads);

/// `rows` gives the expected pairs and shifts (canonical order) of a domain from every level
/// available here with each number of threads, and in `as_found` order the same bytes.
[[nodiscard]] ::testing::AssertionResult rows_agree(const PairList& expected,
                                                    const ElementView& elements,
                                                    const Domain& domain, double margin,
                                                    std::initializer_list<int> threads = {1, 2, 7});

}  // namespace abut::testing
