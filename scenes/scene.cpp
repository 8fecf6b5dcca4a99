// The table of scenes. Tests, benchmarks and the tool read it: a new scene is a maker and a row.

#include "scenes/scene.hpp"

#include "scenes/families.hpp"

#include <abut/error.hpp>

#include <array>
#include <string>

namespace abut::scenes {
namespace {

/// A maker that says so, before it computes anything, when there are too many elements.
template <Scene (*Make)(std::size_t, std::uint64_t)>
Scene checked(std::size_t count, std::uint64_t seed) {
  require_possible(count);
  return Make(count, seed);
}

constexpr std::array table{
    SceneInfo{"pack_1", 2, "the book's pack I: rows of discs that touch exactly",
              checked<make_pack_1>},
    SceneInfo{"pack_2", 2, "the book's pack II: discs two diameters apart in rows",
              checked<make_pack_2>},
    SceneInfo{"pack_3", 2, "the book's pack III: discs two diameters apart both ways",
              checked<make_pack_3>},
    SceneInfo{"pack_4", 2, "the book's pack IV: discs touching in twos", checked<make_pack_4>},
    SceneInfo{"hexagonal_2d", 2, "dense discs: a hexagonal lattice thinned to 0.80 and jittered",
              checked<make_hexagonal_2d>},
    SceneInfo{"gas_2d", 2, "discs at random, filling 0.05 of the plane", checked<make_gas_2d>},
    SceneInfo{"at_reach_2d", 2, "pairs at the sum of their radii within a few last places",
              checked<make_at_reach_2d>},
    SceneInfo{"near_faces_2d", 2, "touching pairs that a cell as wide as the reach would miss",
              checked<make_near_faces_2d>},
    SceneInfo{"near_faces_float32_2d", 2, "the same in float32 numbers",
              checked<make_near_faces_float32_2d>},
    SceneInfo{"dense", 3, "a dense packing of equal spheres, three pairs each, shuffled",
              checked<make_dense>},
    SceneInfo{"dense_spread", 3, "the dense packing with radii spread within 5 %",
              checked<make_dense_spread>},
    SceneInfo{"dense_stray", 3, "the dense packing but for one sphere, 1000000 away from it",
              checked<make_dense_stray>},
    SceneInfo{"boulders", 3, "the dense packing, one sphere in 10000 eight times as large",
              checked<make_boulders>},
    SceneInfo{"ordered", 3, "the dense packing, numbered along space", checked<make_ordered>},
    SceneInfo{"gas", 3, "equal spheres at random, filling 0.05 of a cube", checked<make_gas>},
    SceneInfo{"sph", 3, "particles of a fluid on a shaken cubic lattice, 29 pairs each",
              checked<make_sph>},
    SceneInfo{"sph_lattice", 3, "the same on a lattice of half the reach: three of 16 pairs touch",
              checked<make_sph_lattice>},
    SceneInfo{"sparse", 3, "spheres of radius 1 in a cube 100000 wide", checked<make_sparse>},
    SceneInfo{"clusters", 3, "Gaussian clusters of 1000 in a cube 1000000 wide, three pairs each",
              checked<make_clusters>},
    SceneInfo{"clusters_100", 3, "Gaussian clusters of 100 in the same cube, 2.6 pairs each",
              checked<make_clusters_100>},
    SceneInfo{"clusters_30", 3, "Gaussian clusters of 30 in the same cube, 2.2 pairs each",
              checked<make_clusters_30>},
    SceneInfo{"shell", 3, "equal spheres at random on a sphere far larger, two pairs each",
              checked<make_shell>},
    SceneInfo{"crowds", 3, "equal spheres at distances of all scales from a point, 1 to 10000",
              checked<make_crowds>},
    SceneInfo{"bidisperse", 3, "one sphere in a hundred ten times as large",
              checked<make_bidisperse>},
    SceneInfo{"polydisperse", 3, "radii 1 to 4, each as often", checked<make_polydisperse>},
    SceneInfo{"log_uniform", 3, "radii 1 to 100, each decade as often", checked<make_log_uniform>},
    SceneInfo{"log_uniform_1000", 3, "radii 1 to 1000, each decade as often",
              checked<make_log_uniform_1000>},
    SceneInfo{"graded", 3, "radii 1 to 100, each decade of the same volume", checked<make_graded>},
    SceneInfo{"graded_1000", 3, "radii 1 to 1000, each decade of the same volume",
              checked<make_graded_1000>},
    SceneInfo{"graded_by_place", 3, "radii 1 to 21 that grow with the distance from the middle",
              checked<make_graded_by_place>},
    SceneInfo{"refined", 3, "radii 1 to 13 that grow with the distance from the middle",
              checked<make_refined>},
    SceneInfo{"one_giant", 3, "a gas of small spheres and one as large as all of it",
              checked<make_one_giant>},
    SceneInfo{"touching_cubic", 3, "a simple cubic lattice whose neighbours touch exactly",
              checked<make_touching_cubic>},
    SceneInfo{"touching_fcc", 3, "a face-centred lattice with the smallest radius that touches",
              checked<make_touching_fcc>},
    SceneInfo{"touching_cubic_shuffled", 3, "the simple cubic lattice, shuffled",
              checked<make_touching_cubic_shuffled>},
    SceneInfo{"touching_fcc_shuffled", 3, "the face-centred lattice, shuffled",
              checked<make_touching_fcc_shuffled>},
    SceneInfo{"line", 3, "a string of beads along x", checked<make_line>},
    SceneInfo{"coincident", 3, "all centres in one point: every pair touches",
              checked<make_coincident>},
    SceneInfo{"two_far_clusters", 3, "two groups of spheres 10^18 apart",
              checked<make_two_far_clusters>},
    SceneInfo{"at_reach", 3, "pairs at the sum of their radii within a few last places",
              checked<make_at_reach>},
    SceneInfo{"near_faces", 3, "touching pairs that a cell as wide as the reach would miss",
              checked<make_near_faces>},
    SceneInfo{"near_faces_float32", 3, "the same in float32 numbers",
              checked<make_near_faces_float32>},
};

}  // namespace

std::span<const SceneInfo> scenes() {
  return table;
}

const SceneInfo& scene_named(std::string_view name) {
  for (const SceneInfo& row : table) {
    if (row.name == name) return row;
  }
  throw Error(ErrorCode::wrong_usage,
              "no scene is called '" + std::string(name) + "'; 'abut generate --list' lists them");
}

}  // namespace abut::scenes
