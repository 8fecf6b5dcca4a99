// Probe points against grains: which grains lie within reach of each point.
#include <abut/abut.hpp>

#include <cstdio>
#include <vector>

int main() {
  struct Grain {
    double x, y, z;
  };
  const std::vector<Grain> grains{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {0, 3, 0}};
  const abut::ElementView all_grains =
      abut::spheres(abut::column(grains, &Grain::x), abut::column(grains, &Grain::y),
                    abut::column(grains, &Grain::z), 1.0);

  // The sets may differ in layout, in precision and in radii.
  const std::vector<float> x{1.0F, 3.5F, 9.0F};
  const std::vector<float> y{0.0F, 1.25F, 9.0F};
  const std::vector<float> z{0.0F, 0.0F, 9.0F};
  const abut::ElementView probes = abut::spheres(x, y, z, 0.0);

  // i is a probe and j a grain, whichever is larger.
  for (const abut::ContactPair pair : abut::find_contact_pairs(probes, all_grains)) {
    std::printf("probe %u touches grain %u: gap %g\n", pair.first, pair.second,
                abut::gap(probes, all_grains, pair));
  }

  // One row for each probe, here of the grains within 1 of it.
  const abut::NeighborList list =
      abut::build_neighbor_list(probes, all_grains, abut::Domain::open(), {.margin = 1.0});
  for (std::size_t probe = 0; probe < list.size(); ++probe) {
    std::printf("near probe %zu:", probe);
    for (const abut::ElementIndex grain : list[probe]) std::printf(" %u", grain);
    std::printf("\n");
  }
}
