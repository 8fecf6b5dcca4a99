#include "fuzz/check_neighbors.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

namespace abut::fuzz {
namespace {

constexpr std::size_t most_measured = 12;  ///< rational numbers take their time

void require(bool holds, const std::string& what) {
  if (!holds) throw Failure("neighbor list: " + what);
}

void check_measures(const Question& question, const NeighborList& list,
                    const std::vector<ImagePair>& entries) {
  const testing::ExactOracle oracle = question.oracle();
  const std::size_t step = entries.size() / most_measured + 1;
  for (std::size_t k = 0; k < entries.size(); k += step) {
    const ImagePair image = question.in_oracle(entries[k]);
    const std::string where = " of entry " + std::to_string(k);
    if (!list.distances().empty()) {
      require(oracle.is_distance(image, list.distances()[k]), "distance" + where);
    }
    if (list.vectors().empty()) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      require(oracle.is_component(image, axis, -list.vectors()[k][axis]), "vector" + where);
    }
  }
}

}  // namespace

std::vector<ImagePair> expected_entries(const Question& question, NeighborListKind kind) {
  std::vector<ImagePair> entries = question.expected().pairs;
  if (kind == NeighborListKind::half || question.has_two_sets()) return entries;
  for (const auto& [pair, n] : question.expected().pairs) {
    entries.push_back({{pair.second, pair.first}, {-n.x, -n.y, -n.z}});
  }
  std::ranges::sort(entries);
  return entries;
}

void check_neighbors(const Question& question, const Options& options, NeighborListKind kind,
                     const NeighborList& list) {
  const std::vector<ImagePair> entries = expected_entries(question, kind);
  require(list.size() == question.system().first.size(), "another number of rows");
  require(list.neighbors().size() == entries.size(), "another number of entries");
  const bool shifted = options.shifts == Shifts::stored;
  require(list.shifts().size() == (shifted ? entries.size() : 0), "another number of shifts");
  std::size_t k = 0;
  for (std::size_t e = 0; e < list.size(); ++e) {
    require(list.offsets()[e] == k, "offsets");
    for (std::size_t n = 0; n < list[e].size(); ++n, ++k) {
      require(entries[k].pair == ContactPair{static_cast<ElementIndex>(e), list[e][n]},
              "entry " + std::to_string(k) + " is another neighbor");
      require(!shifted || entries[k].shift == list.shifts()[k],
              "entry " + std::to_string(k) + " has another shift");
    }
  }
  const bool distances = options.quantities.has(Quantity::distance);
  const bool vectors = options.quantities.has(Quantity::vector);
  require(list.distances().size() == (distances ? entries.size() : 0), "distances");
  require(list.vectors().size() == (vectors ? entries.size() : 0), "vectors");
  check_measures(question, list, entries);
}

}  // namespace abut::fuzz
