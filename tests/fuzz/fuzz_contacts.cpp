// Makes a system of the bytes and compares what the library says about it: few elements with the
// contract in whole numbers; many, where ABUT_MOST_ELEMENTS is not 0, with direct checking.

#include "fuzz/check_case.hpp"
#include "fuzz/dump_case.hpp"
#include "fuzz/number_memory.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  abut::fuzz::keep_memory_of_numbers();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abut::fuzz;
  constexpr std::size_t most_elements = ABUT_MOST_ELEMENTS;
  const std::optional<Case> given = most_elements == 0
                                        ? decode_case({data, size})
                                        : decode_large_case({data, size}, most_elements);
  if (!given) return 0;
  try {
    most_elements == 0 ? check_case(*given, Thoroughness::sampled) : check_large_case(*given);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n%s", failure.what(), dump_case(*given).c_str());
    std::abort();
  }
  return 0;
}
