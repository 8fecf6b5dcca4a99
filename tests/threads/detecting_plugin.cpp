#include <abut/abut.hpp>

#include <vector>

/// Contact pairs of a row of touching discs, found by four threads; -1 on an error.
extern "C" __attribute__((visibility("default"))) long contacts_of_a_row() {
  try {
    std::vector<double> x;
    for (int k = 0; k < 40000; ++k) x.push_back(k);
    const std::vector<double> y(x.size());
    const auto found =
        abut::count_contact_pairs(abut::discs(x, y, 0.5), abut::Domain::open(), {.threads = 4});
    return static_cast<long>(found.contact_pairs);
  } catch (...) {
    return -1;
  }
}
