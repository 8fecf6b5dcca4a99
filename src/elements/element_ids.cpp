#include "elements/element_ids.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut::elements {

void ElementIds::set(std::span<const std::uint64_t> ids, std::size_t count) {
  if (!ids.empty() && ids.size() != count) {
    throw Error(ErrorCode::invalid_input, std::to_string(ids.size()) + " ids for " +
                                              std::to_string(count) +
                                              " elements; give one for each, or none");
  }
  count_ = count;
  ids_.assign(ids.begin(), ids.end());
  number_of_.clear();
  ascending_.clear();
  if (!ids.empty() && !fill_table()) fill_ascending();
}

/// False, and no table, where ids are large or one comes twice.
bool ElementIds::fill_table() {
  constexpr std::size_t ids_for_an_element = 4;
  const std::uint64_t largest = *std::max_element(ids_.begin(), ids_.end());
  if (largest / ids_for_an_element > count_ + 256) return false;
  number_of_.resize(static_cast<std::size_t>(largest) + 1, none);
  for (std::size_t k = 0; k < count_; ++k) {
    std::uint32_t& number = number_of_[static_cast<std::size_t>(ids_[k])];
    if (number != none) {
      number_of_.clear();
      return false;
    }
    number = static_cast<std::uint32_t>(k);
  }
  return true;
}

void ElementIds::fill_ascending() {
  ascending_.resize(count_);
  for (std::size_t k = 0; k < count_; ++k) {
    ascending_[k] = {ids_[k], static_cast<std::uint32_t>(k)};
  }
  const auto before = [](const IdEntry& a, const IdEntry& b) {
    return a.id != b.id ? a.id < b.id : a.number < b.number;
  };
  if (!std::is_sorted(ascending_.begin(), ascending_.end(), before)) {
    std::sort(ascending_.begin(), ascending_.end(), before);
  }
  const auto twice =
      std::adjacent_find(ascending_.begin(), ascending_.end(),
                         [](const IdEntry& a, const IdEntry& b) { return a.id == b.id; });
  if (twice == ascending_.end()) return;
  throw Error(ErrorCode::invalid_input, "elements " + std::to_string(twice->number) + " and " +
                                            std::to_string((twice + 1)->number) +
                                            " both have the id " + std::to_string(twice->id) +
                                            "; ids must differ");
}

bool ElementIds::same(std::span<const std::uint64_t> ids, std::size_t count) const noexcept {
  return count == count_ && std::equal(ids.begin(), ids.end(), ids_.begin(), ids_.end());
}

std::uint32_t ElementIds::number_of(std::uint64_t id) const noexcept {
  if (ids_.empty()) return id < count_ ? static_cast<std::uint32_t>(id) : none;
  if (ascending_.empty()) {
    return id < number_of_.size() ? number_of_[static_cast<std::size_t>(id)] : none;
  }
  const auto place = std::partition_point(ascending_.begin(), ascending_.end(),
                                          [id](const IdEntry& other) { return other.id < id; });
  return place != ascending_.end() && place->id == id ? place->number : none;
}

void ElementIds::find_in(const ElementIds& others, std::vector<std::uint32_t>& numbers) const {
  numbers.assign(count_, none);
  if (ascending_.empty() || others.ascending_.empty()) {
    for (std::size_t k = 0; k < count_; ++k) numbers[k] = others.number_of(of(k));
    return;
  }
  auto other = others.ascending_.begin();
  for (const IdEntry& own : ascending_) {
    while (other != others.ascending_.end() && other->id < own.id) ++other;
    if (other == others.ascending_.end()) return;
    if (other->id == own.id) numbers[own.number] = other->number;
  }
}

}  // namespace abut::elements
