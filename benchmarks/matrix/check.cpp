#include "benchmarks/matrix/check.hpp"

#include <algorithm>

namespace abut::benchmarks {

std::vector<ContactPair> ascending(std::span<const ContactPair> pairs) {
  std::vector<ContactPair> sorted(pairs.begin(), pairs.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Difference difference(std::span<const ContactPair> right, std::span<const ContactPair> answer) {
  Difference found;
  std::size_t r = 0;
  std::size_t a = 0;
  while (r < right.size() && a < answer.size()) {
    if (right[r] == answer[a]) {
      ++r;
      ++a;
    } else if (right[r] < answer[a]) {
      ++found.missing;
      ++r;
    } else {
      ++found.extra;
      ++a;
    }
  }
  found.missing += right.size() - r;
  found.extra += answer.size() - a;
  return found;
}

Difference check(Task task, const Answer& answer, std::span<const ContactPair> right) {
  switch (task) {
    case Task::copy:
    case Task::control:
      return {};
    case Task::count:
    case Task::visit:
    case Task::half_list:
    case Task::full_list: {
      const std::uint64_t expected = right.size();
      return {expected - std::min(expected, answer.count),
              answer.count - std::min(expected, answer.count)};
    }
    case Task::canonical:
      return difference(right, answer.pairs);
    default:
      return difference(right, ascending(answer.pairs));
  }
}

}  // namespace abut::benchmarks
