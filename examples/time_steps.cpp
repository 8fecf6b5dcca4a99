// A detector in a loop over time steps: it keeps its memory from step to step.
#include <abut/abut.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

int main() {
  // 20 x 20 x 20 spheres of diameter 1 on a lattice that is pressed together step by step.
  constexpr int side = 20;
  std::vector<double> x, y, z;
  for (int k = 0; k < side * side * side; ++k) {
    x.push_back(k % side);
    y.push_back(k / side % side);
    z.push_back(k / side / side);
  }
  // A view: it sees the positions as they are when a detection begins.
  const abut::ElementView spheres = abut::spheres(x, y, z, 0.5);

  abut::Options options;
  options.order = abut::Order::as_found;  // no order needed here: a little faster
  abut::Detector detector(options);
  for (int step = 0; step < 4; ++step) {
    // The list belongs to the detector and is valid until the next call.
    const abut::PairList& pairs = detector.find_contact_pairs(spheres);
    double deepest = 0.0;
    for (const abut::ContactPair pair : pairs) {
      deepest = std::max(deepest, -abut::gap(spheres, pair));
    }
    std::printf("step %d: %llu contacts, deepest overlap %g\n", step,
                static_cast<unsigned long long>(pairs.size()), deepest);
    for (std::vector<double>* coordinates : {&x, &y, &z}) {
      for (double& coordinate : *coordinates) coordinate *= 0.875;
    }
  }

  // Once in a while only a number is wanted.
  std::printf("in the end %llu\n",
              static_cast<unsigned long long>(detector.count_contact_pairs(spheres).contact_pairs));
}
