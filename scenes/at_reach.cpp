// Pairs planted at a distance that equals the sum of radii within a few units in the last place, in
// random directions: only exact arithmetic tells which of them touch.

#include "scenes/arithmetic.hpp"
#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace abut::scenes {
namespace {

/// Returns a direction, not normalised: any vector longer than 1/2 in the ball of radius 1.
template <std::size_t Dim>
std::array<double, Dim> direction(Random& random) {
  while (true) {
    std::array<double, Dim> vector{};
    double square = 0.0;
    for (double& component : vector) {
      component = random.uniform(-1.0, 1.0);
      square += component * component;
    }
    if (square > 0.25 && square < 1.0) return vector;
  }
}

/// The partner's radius makes up the rest of the distance, and a few steps more or less.
template <std::size_t Dim>
Scene at_reach(std::size_t count, std::uint64_t seed) {
  const double width = 2.0 * static_cast<double>(side_of(count, static_cast<int>(Dim)) + 1);
  Random random(seed);
  Scene scene = empty_scene(static_cast<int>(Dim), count);
  const auto add = [&](const std::array<double, Dim>& center, double radius) {
    if (scene.size() == count) return;
    add_disc(scene, center[0], center[1], radius);
    if constexpr (Dim == 3) scene.z.push_back(center[2]);
  };
  while (scene.size() < count) {
    const std::array<double, Dim> away = direction<Dim>(random);
    const double radius = random.uniform(0.1, 0.2);
    std::array<double, Dim> center{};
    for (double& x : center) x = random.uniform(-0.5, 0.5) * width;
    std::array<double, Dim> partner{};
    double square = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      partner[axis] = center[axis] + away[axis];
      const double difference = partner[axis] - center[axis];
      square += difference * difference;
    }
    const int steps = static_cast<int>(random.below(7)) - 3;
    add(center, radius);
    add(partner, neighbor_number(std::sqrt(square) - radius, steps));
  }
  return scene;
}

}  // namespace

Scene make_at_reach_2d(std::size_t count, std::uint64_t seed) {
  return at_reach<2>(count, seed);
}
Scene make_at_reach(std::size_t count, std::uint64_t seed) {
  return at_reach<3>(count, seed);
}

}  // namespace abut::scenes
