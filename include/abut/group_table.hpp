#pragma once

#include <abut/export.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut {

/// Which of some groups of elements may pair: a symmetric table of one bit for each two groups,
/// which start allowed.
class ABUT_API GroupTable {
 public:
  /// Groups are numbered from 0. Throws Error{limit_exceeded} for more than most_groups.
  explicit GroupTable(std::uint32_t groups);

  static constexpr std::uint32_t most_groups = 32768;  ///< 128 MiB

  [[nodiscard]] std::uint32_t size() const noexcept { return groups_; }

  /// Both orders; a == b is a group with itself. Throws Error{wrong_usage} for groups that are not
  /// there.
  GroupTable& allow(std::uint32_t a, std::uint32_t b);
  GroupTable& deny(std::uint32_t a, std::uint32_t b);

  /// Denies all; for tables in which few pairs are allowed.
  GroupTable& deny_all() noexcept;

  /// Both numbers must be < size().
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
