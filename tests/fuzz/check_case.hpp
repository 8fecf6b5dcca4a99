#pragma once

#include "fuzz/fuzz_case.hpp"

namespace abut::fuzz {

enum class Thoroughness {
  sampled,   ///< each algorithm in one form, which the plan of the case chooses
  complete,  ///< every form, instruction set and some numbers of threads
};

/// Throws Failure where the library differs from the contract, from one algorithm or form to
/// another, or in what it refuses. False where the case has too many images to be looked at.
bool check_case(const Case& given, Thoroughness thoroughness);

/// The same for many elements, in sampled forms, against direct checking.
bool check_large_case(const Case& given);

}  // namespace abut::fuzz
