#pragma once

#include "support/oracle.hpp"

namespace abut::testing {

/// Sorts pairs, ascending. Of a template that a test has as well, which is not optimised, a program
/// keeps one copy, perhaps that of the test; this one is compiled here alone.
void sort_pairs(PairVector& pairs);

}  // namespace abut::testing
