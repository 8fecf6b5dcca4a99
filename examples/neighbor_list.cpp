// The neighbors of each element, as codes that go through particles one by one want them.
#include <abut/abut.hpp>

#include <cstdio>
#include <vector>

namespace {

void print(const char* title, const abut::NeighborList& list) {
  std::printf("%s\n", title);
  for (std::size_t element = 0; element < list.size(); ++element) {
    std::printf("  %zu:", element);
    for (const abut::ElementIndex neighbor : list[element]) std::printf(" %u", neighbor);
    std::printf("\n");
  }
}

}  // namespace

int main() {
  // Four discs in a square, a fifth between them, a sixth far away.
  const std::vector<double> x{0.0, 1.0, 0.0, 1.0, 0.5, 9.0};
  const std::vector<double> y{0.0, 0.0, 1.0, 1.0, 0.5, 9.0};
  const std::vector<double> radius{0.5, 0.5, 0.5, 0.5, 0.25, 0.5};
  const abut::ElementView discs = abut::discs(x, y, radius);

  // Half: each pair once, at its smaller number. Full: from both sides.
  print("half",
        abut::build_neighbor_list(discs, abut::Domain::open(), abut::NeighborListKind::half));
  const abut::NeighborList full =
      abut::build_neighbor_list(discs, abut::Domain::open(), abut::NeighborListKind::full);
  print("full", full);

  // The two arrays behind it are what compressed rows are everywhere; offsets are 64 bits wide.
  std::printf("%zu offsets, %zu neighbors\n", full.offsets().size(), full.neighbors().size());
}
