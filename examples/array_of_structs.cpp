// The caller's own particles, an array of structs in float, seen in place.
#include <abut/abut.hpp>

#include <array>
#include <cstdio>
#include <vector>

namespace {

struct Particle {
  int id;
  float x, y, z;
  float velocity[3];
  float radius;
};

}  // namespace

int main() {
  std::vector<Particle> particles;
  for (int k = 0; k < 5; ++k) {
    particles.push_back({100 + k, 0.25f * static_cast<float>(k), 0.0f, 0.0f, {}, 0.125f});
  }

  // One column per number; the stride is that of the struct. float becomes double without change,
  // so a contact is decided on exactly these numbers.
  const abut::ElementView elements = abut::spheres(
      abut::column(particles, &Particle::x), abut::column(particles, &Particle::y),
      abut::column(particles, &Particle::z), abut::column(particles, &Particle::radius));
  for (const auto& [i, j] : abut::find_contact_pairs(elements)) {
    std::printf("particle %d touches particle %d\n", particles[i].id, particles[j].id);
  }

  // Points of two or three numbers in a row need no columns.
  const std::vector<std::array<float, 2>> centers{{0.0f, 0.0f}, {0.5f, 0.0f}, {0.5f, 0.75f}};
  const abut::PairList pairs = abut::find_contact_pairs(abut::discs(centers, 0.25));
  std::printf("%zu discs, %zu contact\n", centers.size(), pairs.pairs().size());
}
