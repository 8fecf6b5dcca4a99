#pragma once

#include "base/array.hpp"
#include "lattice/wrapper.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::periodic {

/// The number of cells by which each local element was moved. Where ten bits a side will do, one
/// word holds all sides: naming pairs reads them in no order, and what is smaller stays in the
/// cache.
class MovedCells {
 public:
  explicit MovedCells(base::MemoryMeter& memory)
      : words_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        triples_(base::make_array_for_overwrite<lattice::CellsMoved>(memory, 0)) {}

  /// Most cells, of either sign, in a word: differences then fit ten bits, too.
  static constexpr std::int32_t most_packed = 255;

  void make_room(std::size_t count, bool packed) {
    is_packed_ = packed;
    if (packed) {
      base::make_room(words_, count);
    } else {
      base::make_room(triples_, count);
    }
  }

  [[nodiscard]] bool is_packed() const noexcept { return is_packed_; }
  [[nodiscard]] std::uint32_t* words() noexcept { return words_.data(); }
  [[nodiscard]] lattice::CellsMoved* triples() noexcept { return triples_.data(); }
  [[nodiscard]] const std::uint32_t* words() const noexcept { return words_.data(); }
  [[nodiscard]] const lattice::CellsMoved* triples() const noexcept { return triples_.data(); }

  [[nodiscard]] lattice::CellsMoved operator[](std::size_t local) const noexcept {
    return is_packed_ ? unpacked(words_[local]) : triples_[local];
  }

  [[nodiscard]] static std::uint32_t packed(const lattice::CellsMoved& cells) noexcept {
    const auto biased = [](std::int32_t n) { return static_cast<std::uint32_t>(n + zero); };
    return biased(cells[0]) << 20 | biased(cells[1]) << 10 | biased(cells[2]);
  }
  [[nodiscard]] static lattice::CellsMoved unpacked(std::uint32_t word) noexcept {
    return {along(word, bits_of(0)), along(word, bits_of(1)), along(word, bits_of(2))};
  }

  /// Cells of i less cells of j, as one word.
  [[nodiscard]] static std::uint32_t difference(std::uint32_t i, std::uint32_t j) noexcept {
    constexpr std::uint32_t zeros =
        static_cast<std::uint32_t>(zero) * ((1u << 20) + (1u << 10) + 1);
    return i - j + zeros;
  }
  /// The place of a side in a word, and the bits that stand there.
  [[nodiscard]] static int bits_of(std::size_t side) noexcept {
    return 20 - 10 * static_cast<int>(side);
  }
  [[nodiscard]] static std::int32_t along(std::uint32_t word, int bits) noexcept {
    return static_cast<std::int32_t>(word >> bits & 1023u) - zero;
  }

 private:
  static constexpr std::int32_t zero = 512;

  base::Array<std::uint32_t> words_;
  base::Array<lattice::CellsMoved> triples_;
  bool is_packed_ = false;
};

}  // namespace abut::periodic
