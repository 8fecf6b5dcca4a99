#pragma once

#include "base/host_device.hpp"
#include "lattice/ghost_windows.hpp"
#include "lattice/wrapper.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::device {

/// How numbers of cells along the three sides share a word, if none exceeds what is known of it in
/// magnitude. The largest ones of a domain tell how many bits each takes.
class PackedLayout {
 public:
  PackedLayout() = default;

  /// For numbers along the next side.
  void add_side(double largest) noexcept {
    constexpr double most = 2147483647.0;
    if (!(largest <= most)) {
      bits_ += 64;
    } else if (largest >= 1.0) {
      largest_[sides_] = static_cast<std::int64_t>(largest);
      int bits = 1;
      while (std::uint64_t{1} << bits <= 2 * static_cast<std::uint64_t>(largest_[sides_])) ++bits;
      masks_[sides_] = (std::uint64_t{1} << bits) - 1;
      first_bits_[sides_] = bits_;
      bits_ += bits;
    }
    ++sides_;
  }

  /// Bits of a word that all take.
  [[nodiscard]] int bits() const noexcept { return bits_; }

  [[nodiscard]] ABUT_HD std::int32_t number(std::uint64_t word, std::size_t side) const noexcept {
    const std::uint64_t above = (word >> first_bits_[side]) & masks_[side];
    return static_cast<std::int32_t>(static_cast<std::int64_t>(above) - largest_[side]);
  }

  [[nodiscard]] ABUT_HD std::uint64_t word(const lattice::CellsMoved& numbers) const noexcept {
    std::uint64_t word = 0;
    for (std::size_t side = 0; side < 3; ++side) {
      word |= static_cast<std::uint64_t>(numbers[side] + largest_[side]) << first_bits_[side];
    }
    return word;
  }

 private:
  std::int64_t largest_[3] = {0, 0, 0};  ///< in magnitude
  std::uint64_t masks_[3] = {0, 0, 0};
  int first_bits_[3] = {0, 0, 0};  ///< 0 where numbers take none
  int bits_ = 0;
  int sides_ = 0;
};

/// Numbers of cells along the sides, three for each entry: in one word, or, where they are too
/// large for that, as they are.
template <class Word>
struct PackedCells {
  Word* words = nullptr;
  lattice::CellsMoved* wide = nullptr;
  PackedLayout packing = {};

  [[nodiscard]] ABUT_HD bool is_empty() const noexcept {
    return words == nullptr && wide == nullptr;
  }

  [[nodiscard]] ABUT_HD std::int32_t at(std::uint64_t k, std::size_t side) const noexcept {
    return words != nullptr ? packing.number(words[k], side) : wide[k][side];
  }

  [[nodiscard]] ABUT_HD lattice::CellsMoved all(std::uint64_t k) const noexcept {
    return {at(k, 0), at(k, 1), at(k, 2)};
  }

  ABUT_HD void set(std::uint64_t k, const lattice::CellsMoved& numbers) const noexcept {
    if (words != nullptr) {
      words[k] = static_cast<Word>(packing.word(numbers));
    } else {
      wide[k] = numbers;
    }
  }
};

/// The ghosts of a search: an element each, and by how many cells it is moved along the sides.
struct PackedGhosts {
  using Ghost = lattice::Ghost;

  std::uint32_t* elements = nullptr;
  PackedCells<std::uint32_t> cells = {};

  [[nodiscard]] ABUT_HD std::uint32_t element(std::uint64_t k) const noexcept {
    return elements[k];
  }
  [[nodiscard]] ABUT_HD std::int32_t image(std::uint64_t k, std::size_t side) const noexcept {
    return cells.at(k, side);
  }
  [[nodiscard]] ABUT_HD bool is_positive(std::uint64_t k) const noexcept {
    return Ghost{elements[k], cells.all(k)}.is_positive();
  }
};

/// Images that are found pair by pair, as ghosts.
struct ImagesAsGhosts {
  using Ghost = lattice::GhostOf<std::int64_t>;

  const Ghost* ghosts = nullptr;

  [[nodiscard]] ABUT_HD std::uint32_t element(std::uint64_t k) const noexcept {
    return static_cast<std::uint32_t>(ghosts[k].element);
  }
  [[nodiscard]] ABUT_HD std::int64_t image(std::uint64_t k, std::size_t side) const noexcept {
    return ghosts[k].image[side];
  }
  [[nodiscard]] ABUT_HD bool is_positive(std::uint64_t k) const noexcept {
    return ghosts[k].is_positive();
  }
};

}  // namespace abut::device
