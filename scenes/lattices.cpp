// Lattices whose nearest neighbours touch: the usual start of a simulation, and every decision a
// borderline one.

#include "scenes/families.hpp"

#include <array>
#include <cstdint>

namespace abut::scenes {

/// Spacing 1, radius 1/2: distance and sum of radii are equal and exact.
Scene make_touching_cubic(std::size_t count, std::uint64_t) {
  const std::size_t side = side_of(count, 3);
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    add_sphere(scene, static_cast<double>(k % side), static_cast<double>(k / side % side),
               static_cast<double>(k / side / side), 0.5);
  }
  return scene;
}

/// Cubes of side 2, so that all coordinates are integers and neighbours sqrt(2) apart. The radius
/// is the smallest double that touches: sqrt(2) / 2 = 0x0.b504f333f9de6484...
Scene make_touching_fcc(std::size_t count, std::uint64_t) {
  constexpr double radius = 0x1.6a09e667f3bcdp-1;
  constexpr std::array<std::array<std::size_t, 3>, 4> basis{
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}}};
  const std::size_t side = side_of((count + 3) / 4, 3);
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t cube = k / 4;
    const auto& site = basis[k % 4];
    add_sphere(scene, static_cast<double>(2 * (cube % side) + site[0]),
               static_cast<double>(2 * (cube / side % side) + site[1]),
               static_cast<double>(2 * (cube / side / side) + site[2]), radius);
  }
  return scene;
}

Scene make_touching_cubic_shuffled(std::size_t count, std::uint64_t seed) {
  Scene scene = make_touching_cubic(count, seed);
  shuffle(scene, seed);
  return scene;
}

Scene make_touching_fcc_shuffled(std::size_t count, std::uint64_t seed) {
  Scene scene = make_touching_fcc(count, seed);
  shuffle(scene, seed);
  return scene;
}

}  // namespace abut::scenes
