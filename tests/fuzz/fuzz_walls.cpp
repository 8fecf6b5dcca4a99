// Makes spheres and walls of the bytes and compares their contacts with the contract in rational
// numbers.

#include "fuzz/number_memory.hpp"
#include "fuzz/wall_case.hpp"

#include <cstddef>
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
  const std::optional<WallCase> given = decode_wall_case({data, size});
  if (!given) return 0;
  try {
    check_wall_case(*given);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n%s", failure.what(), dump_wall_case(*given).c_str());
    std::abort();
  }
  return 0;
}
