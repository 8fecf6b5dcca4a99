// A drum that turns around spheres: walls of triangles that move, friction that remembers from
// facet to facet, and an energy ledger that closes. grains.hpp has the method.
//
//   drum N STEPS DT [FRAMES]
//
// The spheres fall to the bottom, and the drum lifts them on one side until they slide back. What
// the drum does of work becomes heat, but for what lifts the spheres. FRAMES: a prefix of VTP
// files.
#include "grains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

using namespace grains;

constexpr double drum_radius = 5.0, drum_length = 6.0, turning = 0.6;

/// A closed cylinder around the axis x, of triangles that each have corners of their own, as STL
/// files have them. Corners at the same place become one vertex: without that there would be a seam
/// beside every triangle, and no sphere could roll on from one to the next.
abut::TriangleMesh make_drum(int facets) {
  std::vector<Vec> corners;
  std::vector<Triangle> triangles;
  const auto add = [&](const Vec& a, const Vec& b, const Vec& c) {
    const int first = static_cast<int>(corners.size());
    corners.insert(corners.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
  };
  const auto rim = [&](double x, int k) {
    const double angle = 2.0 * std::numbers::pi * (k % facets) / facets;
    return Vec{x, drum_radius * std::cos(angle), drum_radius * std::sin(angle)};
  };
  const double left = -0.5 * drum_length, right = 0.5 * drum_length;
  for (int k = 0; k < facets; ++k) {
    add(rim(left, k), rim(left, k + 1), rim(right, k + 1));
    add(rim(left, k), rim(right, k + 1), rim(right, k));
    for (const double x : {left, right}) add({x, 0, 0}, rim(x, k), rim(x, k + 1));
  }
  return abut::TriangleMesh::joined(corners, triangles);
}

/// The first `count` places of a lattice in the drum, from below.
void fill(Grains& drum, int count) {
  constexpr double spacing = 1.02, room = drum_radius - 0.55;
  std::uint64_t state = 1;
  for (double z = 0.1 - room; z < room; z += spacing) {
    const double half = std::sqrt(room * room - z * z);
    for (double y = -half; y <= half; y += spacing) {
      for (double x = 0.55 - 0.5 * drum_length; x < 0.5 * drum_length - 0.5; x += spacing) {
        if (count-- <= 0) return;
        drum.add({x, y, z}, {}, 0.45 + 0.05 * noise(state));
      }
    }
  }
}

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 200;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 10000;
  const double dt = argc > 3 ? std::atof(argv[3]) : 5e-4;
  if (count < 1 || steps < 1 || !(dt > 0.0)) {
    std::fprintf(stderr, "usage: drum N STEPS DT [FRAMES]\n");
    return 2;
  }
  Grains drum(dt, {0.0, 0.0, -10.0}, make_drum(48), turning);
  fill(drum, count);
  drum.find_forces();
  drum.print("drum");
  std::size_t rolled = 0;
  for (int step = 1; step <= steps; ++step) {
    drum.step();
    rolled += drum.passed_on();
    if (step % std::max(steps / 5, 1) != 0) continue;
    drum.print("drum");
    if (argc > 4) drum.write_frame(argv[4] + std::to_string(step) + ".vtp");
  }
  double farthest = 0.0, sideways = 0.0;
  for (const Vec& x : drum.positions()) {
    farthest = std::max(farthest, std::hypot(x[1], x[2]));
    sideways += x[1] / static_cast<double>(drum.positions().size());
  }
  std::printf("%zu spheres, farthest %.3f, mean %.3f to the side; %zu times from facet to facet\n",
              drum.positions().size(), farthest, sideways, rolled);
  return 0;
}
