// Gives bytes to the reader of pairs. Whatever they are, it reads pairs of elements that are there,
// or throws Error.

#include "io/read/read_pairs.hpp"

#include <abut/error.hpp>

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto require = [](bool holds) {
    if (!holds) std::abort();
  };
  const int descriptor = ::memfd_create("fuzz", 0);
  require(descriptor >= 0 && ::write(descriptor, data, size) == static_cast<ssize_t>(size));
  try {
    const std::string path = "/proc/self/fd/" + std::to_string(descriptor);
    for (const abut::ContactPair pair : abut::io::read_pairs(path, {10, 1000})) {
      require(pair.first < 10 && pair.second < 1000);
    }
  } catch (const abut::Error& error) {
    require(error.code() == abut::ErrorCode::invalid_input && std::strlen(error.what()) < 3000);
  }
  ::close(descriptor);
  return 0;
}
