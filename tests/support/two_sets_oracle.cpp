#include "support/two_sets_oracle.hpp"

namespace abut::testing {
namespace {

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Whether a pair of the joined scene is one of both sets, and then its own numbers.
bool name_cross_pair(ContactPair& pair, std::size_t first_count) {
  if (pair.first >= first_count || pair.second < first_count) return false;
  pair.second -= static_cast<ElementIndex>(first_count);
  return true;
}

}  // namespace

scenes::Scene joined(const scenes::Scene& first, const scenes::Scene& second) {
  scenes::Scene both = first;
  append(both.x, second.x);
  append(both.y, second.y);
  append(both.z, second.z);
  append(both.radius, second.radius);
  return both;
}

PairVector oracle_cross_pairs(const scenes::Scene& first, const scenes::Scene& second,
                              double margin) {
  PairVector result;
  for (ContactPair pair : oracle_pairs(joined(first, second), margin)) {
    if (name_cross_pair(pair, first.size())) result.push_back(pair);
  }
  return result;
}

std::vector<ImagePair> oracle_cross_image_pairs(const scenes::Scene& first,
                                                const scenes::Scene& second, const Domain& domain,
                                                double margin, std::int32_t farthest) {
  std::vector<ImagePair> result;
  for (ImagePair image : oracle_image_pairs(joined(first, second), domain, margin, farthest)) {
    if (name_cross_pair(image.pair, first.size())) result.push_back(image);
  }
  return result;
}

}  // namespace abut::testing
