// Dense random packings without a simulation: lattice sites, some left out, jittered, shuffled.

#include "scenes/arithmetic.hpp"
#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace abut::scenes {
namespace {

constexpr double radius = 1.0;
constexpr double jitter = 0.05;

/// Keeps exactly `wanted` of `sites`, each set equally likely.
/// D. E. Knuth, The Art of Computer Programming 2, section 3.4.2, algorithm S.
class Selection {
 public:
  Selection(std::size_t wanted, std::size_t sites, Random& random)
      : wanted_(wanted), left_(sites), random_(random) {}

  bool keep() {
    const bool kept = random_.below(left_) < wanted_;
    --left_;
    if (kept) --wanted_;
    return kept;
  }

 private:
  std::size_t wanted_;
  std::size_t left_;
  Random& random_;
};

/// Returns how many sites of a lattice are needed so that `count` of them fill the fraction
/// `thinned`.
std::size_t site_count(std::size_t count, double lattice_fraction, double thinned) {
  const double sites = static_cast<double>(count) * lattice_fraction / thinned;
  return std::max(count, static_cast<std::size_t>(sites));
}

}  // namespace

Scene make_hexagonal_2d(std::size_t count, std::uint64_t seed) {
  constexpr double lattice_fraction = 0.93;
  const std::size_t sites = site_count(count, lattice_fraction, 0.80);
  const std::size_t columns = side_of(sites, 2);
  const double height = std::sqrt(3.0) * 0.5;
  const double spacing = radius * std::sqrt(pi / (lattice_fraction * height));

  Random random(seed);
  Selection selection(count, sites, random);
  Scene scene = empty_scene(2, count);
  for (std::size_t k = 0; k < sites; ++k) {
    if (!selection.keep()) continue;
    const std::size_t row = k / columns;
    const double shift = row % 2 == 0 ? 0.0 : 0.5;
    const double x = (static_cast<double>(k % columns) + shift) * spacing;
    const double y = static_cast<double>(row) * height * spacing;
    const double x_jitter = jitter * random.gaussian();
    const double y_jitter = jitter * random.gaussian();
    add_disc(scene, x + x_jitter, y + y_jitter, radius);
  }
  shuffle(scene, seed + 1);
  return scene;
}

Scene make_dense(std::size_t count, std::uint64_t seed) {
  constexpr double lattice_fraction = 0.775;
  constexpr std::array<std::array<double, 3>, 4> basis{
      {{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}}};
  const std::size_t sites = site_count(count, lattice_fraction, 0.60);
  const std::size_t side = side_of((sites + 3) / 4, 3);
  const double lattice = radius * cube_root(16.0 * pi / (3.0 * lattice_fraction));

  Random random(seed);
  Selection selection(count, sites, random);
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < sites; ++k) {
    if (!selection.keep()) continue;
    const std::size_t cell = k / 4;
    const std::array<std::size_t, 3> place{cell % side, cell / side % side, cell / side / side};
    std::array<double, 3> center{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      center[axis] = (static_cast<double>(place[axis]) + basis[k % 4][axis]) * lattice +
                     jitter * random.gaussian();
    }
    add_sphere(scene, center[0], center[1], center[2], radius);
  }
  shuffle(scene, seed + 1);
  return scene;
}

/// The centres of `dense`, in the same order.
Scene make_dense_spread(std::size_t count, std::uint64_t seed) {
  constexpr double spread = 0.05;
  Scene scene = make_dense(count, seed);
  Random random(seed + 2);  // the lattice and its numbering take the two before
  for (double& own : scene.radius) own = radius * random.uniform(1.0 - spread, 1.0 + spread);
  return scene;
}

/// One element of `dense` was blown out of it, many times as far as the cube is wide.
Scene make_dense_stray(std::size_t count, std::uint64_t seed) {
  constexpr double far = 1e6;
  Scene scene = make_dense(count, seed);
  if (count > 1) scene.x[count / 2] += far;
  return scene;
}

/// As among sand.
Scene make_boulders(std::size_t count, std::uint64_t seed) {
  constexpr std::size_t one_in = 10000;
  constexpr double larger = 8.0;
  Scene scene = make_dense(count, seed);
  for (std::size_t k = 0; k < count; k += one_in) scene.radius[k] *= larger;
  return scene;
}

Scene make_ordered(std::size_t count, std::uint64_t seed) {
  const Scene scene = make_dense(count, seed);
  // Positive, so that the conversion is a floor.
  const auto cell = [](double x) { return static_cast<int>((x + radius) / (2.0 * radius)); };
  std::vector<std::array<int, 3>> cells(count);
  for (std::size_t k = 0; k < count; ++k) {
    cells[k] = {cell(scene.z[k]), cell(scene.y[k]), cell(scene.x[k])};
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&cells](std::size_t a, std::size_t b) { return cells[a] < cells[b]; });
  return reordered(scene, order);
}

}  // namespace abut::scenes
