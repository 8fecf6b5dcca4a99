#include <abut/abut.hpp>

#include <cstdio>
#include <vector>

int main() {
  const std::vector<double> x{0.0, 1.0, 1.75, 4.0};
  const std::vector<double> y{0.0, 0.0, 0.0, 0.0};
  const std::vector<double> z{0.0, 0.0, 0.0, 0.0};
  const std::vector<double> radius{0.5, 0.5, 0.5, 0.5};

  // A view of the arrays above; it copies nothing.
  const abut::ElementView elements = abut::spheres(x, y, z, radius);
  const abut::PairList pairs = abut::find_contact_pairs(elements);

  for (const abut::ContactPair pair : pairs) {
    std::printf("%u touches %u, gap %g\n", pair.first, pair.second, abut::gap(elements, pair));
  }
}
