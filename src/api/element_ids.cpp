#include "api/element_ids.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut::api {

void ElementIds::set(std::span<const std::uint64_t> ids, std::size_t count) {
  if (!ids.empty() && ids.size() != count) {
    throw Error(ErrorCode::invalid_input, std::to_string(ids.size()) + " ids for " +
                                              std::to_string(count) +
                                              " elements; give one for each, or none");
  }
  count_ = count;
  ids_.assign(ids.begin(), ids.end());
  ascending_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    ascending_[k] = {of(k), static_cast<std::uint32_t>(k)};
  }
  const auto before = [](const Place& a, const Place& b) {
    return a.id != b.id ? a.id < b.id : a.number < b.number;
  };
  if (!std::is_sorted(ascending_.begin(), ascending_.end(), before)) {
    std::sort(ascending_.begin(), ascending_.end(), before);
  }
  const auto twice =
      std::adjacent_find(ascending_.begin(), ascending_.end(),
                         [](const Place& a, const Place& b) { return a.id == b.id; });
  if (twice == ascending_.end()) return;
  throw Error(ErrorCode::invalid_input, "elements " + std::to_string(twice->number) + " and " +
                                            std::to_string((twice + 1)->number) +
                                            " both have the id " + std::to_string(twice->id) +
                                            "; ids must differ");
}

bool ElementIds::same(std::span<const std::uint64_t> ids, std::size_t count) const noexcept {
  return count == count_ && std::equal(ids.begin(), ids.end(), ids_.begin(), ids_.end());
}

void ElementIds::find_in(const ElementIds& others, std::vector<std::uint32_t>& numbers) const {
  numbers.assign(count_, none);
  auto other = others.ascending_.begin();
  for (const Place& own : ascending_) {
    while (other != others.ascending_.end() && other->id < own.id) ++other;
    if (other == others.ascending_.end()) return;
    if (other->id == own.id) numbers[own.number] = other->number;
  }
}

}  // namespace abut::api
