// The table of contestants. Its rows are written by CMake: benchmarks/matrix/CMakeLists.txt names
// each contestant once, and finds its library.

#include "benchmarks/matrix/contestants.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace abut::benchmarks {

#define ABUT_CONTESTANT(name) std::vector<Entry> enter_##name();
#include <contestants_found.inl>
#undef ABUT_CONTESTANT

std::vector<Entry> all_contestants() {
  std::vector<Entry> all;
  const auto add = [&all](std::vector<Entry> entries) {
    std::move(entries.begin(), entries.end(), std::back_inserter(all));
  };
#define ABUT_CONTESTANT(name) add(enter_##name());
#include <contestants_found.inl>
#undef ABUT_CONTESTANT
  for (std::size_t k = 0; k < all.size(); ++k) all[k].number = k;
  return all;
}

std::string_view name_of(Task task) {
  switch (task) {
    case Task::list:
      return "list";
    case Task::canonical:
      return "canonical";
    case Task::count:
      return "count";
    case Task::visit:
      return "visit";
    case Task::half_list:
      return "half_list";
    case Task::full_list:
      return "full_list";
    case Task::control:
      return "control";
    default:
      return "copy";
  }
}

}  // namespace abut::benchmarks
