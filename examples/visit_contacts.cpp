// Contacts as they are found, without a list of them: coordination numbers of a packing.
#include <abut/abut.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

int main() {
  // 100 x 100 discs of diameter 1 on a square lattice. Distance 1, radii 1/2 + 1/2: they touch, and
  // touching counts.
  std::vector<double> x, y;
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 100; ++column) {
      x.push_back(column);
      y.push_back(row);
    }
  }
  const double radius = 0.5;  // one number does for all
  const abut::ElementView elements = abut::discs(x, y, radius);

  // Memory follows the elements, not the contacts. Pairs come in the order in which the algorithm
  // meets them; a result that depends on the order should use find_contact_pairs. With more than
  // one thread the visitor would be called from all of them at the same time.
  abut::Options alone;
  alone.threads = 1;
  std::vector<int> coordination(elements.size(), 0);
  const abut::Statistics statistics = abut::for_each_contact_pair(
      elements, abut::Domain::open(), alone, [&coordination](abut::ContactPair pair) {
        ++coordination[pair.first];
        ++coordination[pair.second];
      });

  std::printf("%llu contacts\n", static_cast<unsigned long long>(statistics.contact_pairs));
  for (int neighbors = 0; neighbors <= 4; ++neighbors) {
    const auto discs = std::count(coordination.begin(), coordination.end(), neighbors);
    std::printf("%d neighbors: %td discs\n", neighbors, discs);
  }

  // A margin asks for more than touching: here the diagonal neighbors too, sqrt(2) - 1 apart.
  abut::Options near;
  near.margin = 0.5;
  const abut::Statistics counted = abut::count_contact_pairs(elements, abut::Domain::open(), near);
  std::printf("%llu pairs with a gap of at most 0.5\n",
              static_cast<unsigned long long>(counted.contact_pairs));
}
