// Data of contacts through time: discs in a row, each contact with a spring that remembers how far
// its discs have slid along each other (P. A. Cundall and O. D. L. Strack, A discrete
// numerical model for granular assemblies, Geotechnique 29, 1979, 47-65).
#include <abut/abut.hpp>

#include <cstdint>
#include <cstdio>
#include <vector>

struct Contact {
  double slid = 0.0;  // of the second disc beside the first, along y
  int steps = 0;
};

int main() {
  // In a box that repeats every 4 along x. Each disc has a name of its own, its id.
  std::vector<std::uint64_t> id{10, 11, 12, 13};
  std::vector<double> x{0.5, 1.4, 2.3, 3.6}, y{1.0, 1.0, 1.0, 1.0};
  const std::vector<double> vx{-0.1, -0.1, 0.0, 0.0}, vy{0.0, 0.01, 0.0, -0.01};
  const abut::Domain domain = abut::Domain::periodic({4.0, abut::unbounded});

  abut::Detector detector({.shifts = abut::Shifts::stored});
  detector.set_skin(abut::Skin::automatic());
  abut::ContactHistory<Contact> history;
  for (int step = 0; step < 8; ++step) {
    const abut::ElementView discs = abut::discs(x, y, 0.5);
    const abut::PairList& pairs = detector.find_contact_pairs(discs, domain);
    history.update(pairs, discs, domain, id);
    std::printf("step %d: %d kept, %d born, %d lost\n", step, static_cast<int>(history.kept()),
                static_cast<int>(history.born().size()), static_cast<int>(history.lost().size()));
    for (const auto& lost : history.lost()) {
      std::printf("  %d and %d parted after %d steps, slid by %.2f\n", static_cast<int>(lost.first),
                  static_cast<int>(lost.second), lost.value.steps, lost.value.slid);
    }
    // Where elements changed roles, what points from the first to the second turns around.
    for (const abut::PairCount k : history.flipped()) history.values()[k].slid *= -1.0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      Contact& contact = history.values()[k];
      if (step == 7) {
        std::printf("  %d and %d touch since %d steps\n", static_cast<int>(id[pairs[k].first]),
                    static_cast<int>(id[pairs[k].second]), contact.steps);
      }
      contact.slid += vy[pairs[k].second] - vy[pairs[k].first];
      ++contact.steps;
    }
    for (std::size_t k = 0; k < x.size(); ++k) {
      x[k] += vx[k];
      y[k] += vy[k];
      if (x[k] < 0.0) x[k] += 4.0;  // wrapped: its contacts stay what they are
    }
  }
}
