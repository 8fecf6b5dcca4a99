#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>

namespace abut::determinism {

/// FNV-1a, 64 bits (G. Fowler, L. C. Noll, K.-P. Vo): enough to tell results apart, and needs no
/// library on any processor. Numbers go in byte by byte, the least significant first, so that the
/// byte order of the machine does not matter.
class FnvDigest {
 public:
  void add(std::uint32_t value) { add_bytes(value, 4); }
  void add(double value) { add_bytes(std::bit_cast<std::uint64_t>(value), 8); }

  [[nodiscard]] std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(state_));
    return digits;
  }

 private:
  void add_bytes(std::uint64_t value, int count) {
    for (int byte = 0; byte < count; ++byte) {
      state_ ^= (value >> (8 * byte)) & 0xff;
      state_ *= 0x100000001b3;
    }
  }

  std::uint64_t state_ = 0xcbf29ce484222325;
};

}  // namespace abut::determinism
