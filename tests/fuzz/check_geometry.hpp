#pragma once

#include "fuzz/question.hpp"

namespace abut::fuzz {

/// Throws Failure unless all quantities of the pairs are those of the contract, with the same bits
/// from every instruction set.
void check_geometry(const Question& question);

}  // namespace abut::fuzz
