#include "base/lack_of_memory.hpp"

#include <abut/error.hpp>
#include <abut/group_table.hpp>

#include <algorithm>
#include <cstdint>
#include <string>

namespace abut {

GroupTable::GroupTable(std::uint32_t groups) : groups_(groups) {
  base::reporting_lack_of_memory([&] {
    if (groups > most_groups) {
      throw Error(ErrorCode::limit_exceeded,
                  "a table of " + std::to_string(groups) + " groups; it holds at most " +
                      std::to_string(most_groups) + ": join groups, or take categories");
    }
    bits_.assign((std::size_t{groups} * groups + 63) / 64, ~std::uint64_t{0});
  });
}

GroupTable& GroupTable::allow(std::uint32_t a, std::uint32_t b) {
  base::reporting_lack_of_memory([&] { set(a, b, 1); });
  return *this;
}

GroupTable& GroupTable::deny(std::uint32_t a, std::uint32_t b) {
  base::reporting_lack_of_memory([&] { set(a, b, 0); });
  return *this;
}

GroupTable& GroupTable::deny_all() noexcept {
  std::fill(bits_.begin(), bits_.end(), std::uint64_t{0});
  return *this;
}

void GroupTable::set(std::uint32_t a, std::uint32_t b, std::uint64_t value) {
  const std::uint32_t larger = std::max(a, b);
  if (larger >= groups_) {
    throw Error(ErrorCode::wrong_usage, "group " + std::to_string(larger) + " in a table of " +
                                            std::to_string(groups_) +
                                            " groups; they are numbered from 0");
  }
  for (const std::size_t bit : {place(a, b), place(b, a)}) {
    std::uint64_t& word = bits_[bit / 64];
    word = (word & ~(std::uint64_t{1} << (bit % 64))) | value << (bit % 64);
  }
}

}  // namespace abut
