// Contacts through the faces of a periodic box: which image of an element is touched.
#include <abut/abut.hpp>

#include <cstdio>
#include <vector>

namespace {

void print(const char* title, const abut::ElementView& discs, const abut::Domain& domain) {
  abut::Options options;
  options.shifts = abut::Shifts::stored;
  const abut::PairList pairs = abut::find_contact_pairs(discs, domain, options);
  std::printf("%s: %zu contacts\n", title, pairs.pairs().size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const abut::ContactPair pair = pairs[k];
    const abut::ImageShift n = pairs.shifts()[k];
    std::printf("  %u and %u moved by (%d, %d): gap %g\n", pair.first, pair.second, n.x, n.y,
                abut::gap(discs, domain, pair, n));
  }
}

}  // namespace

int main() {
  // A disc at the left, one at the right, one far outside of the box.
  const std::vector<double> x{0.25, 3.75, 16.75};
  const std::vector<double> y{1.0, 1.0, -5.0};
  const abut::ElementView discs = abut::discs(x, y, 0.5);

  print("open", discs, abut::Domain::open());
  print("periodic", discs, abut::Domain::periodic({4.0, 3.0}));
  print("only along x", discs, abut::Domain::periodic({4.0, abut::unbounded}));
  print("sheared", discs, abut::Domain::lees_edwards({4.0, 3.0}, 1.5));
  // So narrow that each disc touches images of itself.
  const std::vector<double> zero{0.0};
  print("narrow", abut::discs(zero, zero, 0.5), abut::Domain::lattice({1.0, 0.0}, {0.5, 0.75}));
}
