#pragma once

#include <abut/export.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut {

/// Table of the groups of elements that may pair: symmetric, one bit for each two groups. At first
/// all may pair.
class ABUT_API GroupTable {
 public:
  /// Makes a table for groups 0 to `groups` − 1. Throws Error{limit_exceeded} for more than
  /// most_groups.
  explicit GroupTable(std::uint32_t groups);

  /// Largest number of groups; the table then takes 128 MiB.
  static constexpr std::uint32_t most_groups = 32768;

  /// Number of groups.
  [[nodiscard]] std::uint32_t size() const noexcept { return groups_; }

  /// Allows pairs of an element of group a and one of group b, in both orders; a may equal b.
  /// Throws Error{wrong_usage} for a group that does not exist.
  GroupTable& allow(std::uint32_t a, std::uint32_t b);
  /// Denies pairs of an element of group a and one of group b, in both orders; a may equal b.
  /// Throws Error{wrong_usage} for a group that does not exist.
  GroupTable& deny(std::uint32_t a, std::uint32_t b);

  /// Denies all pairs; a start for tables that allow few.
  GroupTable& deny_all() noexcept;

  /// The bits of the table, those of 64 places in a word: that of groups a and b is bit p % 64 of
  /// word p / 64, for p = a * size() + b.
  [[nodiscard]] std::span<const std::uint64_t> words() const noexcept { return bits_; }

  /// True if elements of these groups may pair. Both numbers must be < size().
  [[nodiscard]] bool allows(std::uint32_t a, std::uint32_t b) const noexcept {
    const std::size_t bit = place(a, b);
    return (bits_[bit / 64] >> (bit % 64) & 1U) != 0;
  }

 private:
  [[nodiscard]] std::size_t place(std::uint32_t a, std::uint32_t b) const noexcept {
    return static_cast<std::size_t>(a) * groups_ + b;
  }
  void set(std::uint32_t a, std::uint32_t b, std::uint64_t value);

  std::uint32_t groups_;
  std::vector<std::uint64_t> bits_;
};

}  // namespace abut
