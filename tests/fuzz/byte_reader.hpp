#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace abut::fuzz {

/// Reads bytes one after the other. Behind the last it goes on with numbers that follow from the
/// first ones, so that short inputs describe many elements.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
    for (std::size_t k = 0; k < bytes.size() && k < 8; ++k) state_ = 257 * state_ + bytes[k];
  }

  [[nodiscard]] std::uint8_t byte() {
    if (next_ < bytes_.size()) return bytes_[next_++];
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint8_t>(state_ >> 56);
  }

  /// A number below `end`, which is at most 256.
  [[nodiscard]] std::size_t below(std::size_t end) { return byte() % end; }

  [[nodiscard]] bool flag() { return (byte() & 1U) != 0; }

  [[nodiscard]] int signed_byte() { return static_cast<std::int8_t>(byte()); }

  [[nodiscard]] std::uint64_t word() {
    std::uint64_t result = 0;
    for (int k = 0; k < 8; ++k) result = result << 8 | byte();
    return result;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  std::uint64_t state_ = 1;
};

}  // namespace abut::fuzz
