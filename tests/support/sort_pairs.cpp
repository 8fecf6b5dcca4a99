#include "support/sort_pairs.hpp"

#include <algorithm>

namespace abut::testing {

void sort_pairs(PairVector& pairs) {
  // The type of this comparison is no other file's, and so is the sort that is made for it.
  std::sort(pairs.begin(), pairs.end(), [](const ContactPair& a, const ContactPair& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
}

}  // namespace abut::testing
