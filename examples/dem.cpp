// A small discrete element method on abut's public interface. grains.hpp has the method, this file
// what is done with it:
//
//   dem settle N STEPS DT [FRAMES]   rain into a box         dem column ...   a column collapses
//   dem fly ...                      a cloud without walls   dem restart ...  settle, halfway anew
//   dem profile ...                  a flat bed; then what 100 more steps spend their time on
//
// FRAMES: a prefix of VTP files for ParaView.
#include "grains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace grains;

constexpr double spacing = 1.05;  // of the lattice to begin with; diameters are 0.8 to 1

/// A floor, four walls around it as far as `height` is more than 0, or nothing where it is less.
abut::TriangleMesh box(double from, double to, double height) {
  std::vector<Vec> corners;
  for (const double z : {0.0, height}) {
    corners.insert(corners.end(), {{from, from, z}, {to, from, z}, {to, to, z}, {from, to, z}});
  }
  std::vector<Triangle> triangles;
  if (height >= 0.0) triangles = {{0, 1, 2}, {0, 2, 3}};
  for (int a = 0; a < 4 && height > 0.0; ++a) {
    const int b = (a + 1) % 4;
    triangles.push_back({a, b, b + 4});
    triangles.push_back({a, b + 4, a + 4});
  }
  return abut::TriangleMesh(corners, triangles);
}

/// `count` spheres on a lattice of `side` columns each way, with some disorder.
void fill(Grains& dem, int count, int side, double speed) {
  std::uint64_t state = 1;
  const auto random = [&] { return noise(state); };
  for (int k = 0; k < count; ++k) {
    const Vec cell{0.5 + k % side, 0.5 + k / side % side, 0.5 + k / side / side};
    dem.add(spacing * cell, speed * Vec{random(), random(), random()}, 0.45 + 0.05 * random());
  }
}

Grains make(const std::string& what, int count, double dt) {
  const bool flat = what == "profile";  // a bed of eight layers, which comes to rest soon
  const double share = count / (what == "column" ? 3.0 : 1.5);
  const int side = std::max(2, static_cast<int>(flat ? std::sqrt(count / 8.0) : std::cbrt(share)));
  const double wall = spacing * side, height = spacing * (count / side / side + 20);
  const bool flies = what == "fly", collapses = what == "column";
  Grains dem(dt,
             Vec{0.0, 0.0,
                 flies  ? 0.0
                 : flat ? -10.0
                        : -1.0},
             flies       ? box(0.0, wall, -1.0)
             : collapses ? box(-50.0 * wall, 51.0 * wall, 0.0)
                         : box(0.0, wall, height));
  fill(dem, count, side, flies ? 2.0 : 0.2);
  return dem;
}

/// Stops halfway and goes on in another program's place: both must end with the same bits.
int check_restart(Grains& dem, int count, int steps, double dt) {
  for (int step = 0; step < steps / 2; ++step) dem.step();
  Grains other = make("settle", count, dt);
  other.resume(dem.state());
  for (int step = 0; step < steps / 2; ++step) dem.step(), other.step();
  std::printf("restart: %s\n", dem.equals(other) ? "the same bits" : "DIFFERENT");
  return dem.equals(other) ? 0 : 7;
}

void print_profile(Grains& dem) {
  const char* const names[] = {"contacts", "history", "forces", "integration"};
  constexpr int steps = 100;
  dem.forget_seconds();
  for (int step = 0; step < steps; ++step) dem.step();
  double sum = 0.0;
  for (const double seconds : dem.seconds()) sum += seconds;
  for (int phase = 0; phase < phases; ++phase) {
    const double seconds = dem.seconds()[static_cast<std::size_t>(phase)];
    std::printf("%-12s %8.3f ms a step  %5.1f %%\n", names[phase], 1e3 * seconds / steps,
                100.0 * seconds / sum);
  }
}

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "settle";
  const int count = argc > 2 ? std::atoi(argv[2]) : 300;
  const int steps = argc > 3 ? std::atoi(argv[3]) : 2000;
  const double dt = argc > 4 ? std::atof(argv[4]) : 5e-4;
  if (count < 1 || steps < 1 || !(dt > 0.0)) {
    std::fprintf(stderr, "usage: dem settle|column|fly|restart|profile N STEPS DT [FRAMES]\n");
    return 2;
  }
  Grains dem = make(what, count, dt);
  dem.find_forces();
  if (what == "restart") return check_restart(dem, count, steps, dt);
  dem.print(what.c_str());
  for (int step = 1; step <= steps; ++step) {
    dem.step();
    if (step % std::max(steps / 5, 1) != 0) continue;
    dem.print(what.c_str());
    if (argc > 5) dem.write_frame(argv[5] + std::to_string(step) + ".vtp");
  }
  if (what == "profile") print_profile(dem);
  return 0;
}
