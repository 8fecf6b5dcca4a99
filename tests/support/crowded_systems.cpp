#include "support/crowded_systems.hpp"

#include "scenes/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

using Point = std::array<double, 3>;

double one_of(Random& random, std::initializer_list<double> values) {
  return values.begin()[random.below(values.size())];
}

/// Powers of two only: std::pow differs from machine to machine.
double random_scale(Random& random, int lowest, int highest) {
  const auto steps = static_cast<std::size_t>(highest - lowest + 1);
  return std::ldexp(random.uniform(1.0, 2.0), lowest + static_cast<int>(random.below(steps)));
}

/// How the radii of a swarm are spread.
struct Sizes {
  double smallest;
  int octaves;         ///< the largest is 2^octaves times as large
  double share_large;  ///< 1: log-uniform; less: so many large ones among small ones

  [[nodiscard]] double next(Random& random) const {
    if (octaves == 0) return smallest;
    if (share_large < 1.0) {
      return random.uniform() < share_large ? std::ldexp(smallest, octaves) : smallest;
    }
    return smallest * random_scale(random, 0, octaves - 1);
  }
};

/// A part of a system: a center, and along each axis how far elements stray from it.
struct Swarm {
  Point center{};
  Point width{};
  Point drift{};  ///< elements lie along it: a filament
  bool even = false;
  Sizes sizes{};

  [[nodiscard]] Point next(Random& random) const {
    Point point = center;
    const double along = random.uniform(-0.5, 0.5);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double stray = even ? random.uniform(-0.5, 0.5) : random.gaussian();
      point[axis] += along * drift[axis] + stray * width[axis];
    }
    return point;
  }
};

/// About so many partners an element if its swarm were even.
Sizes sizes_for(Random& random, double spacing) {
  Sizes sizes{};
  sizes.octaves = static_cast<int>(one_of(random, {0, 0, 1, 3, 5, 7, 10, 14, 21}));
  sizes.share_large = one_of(random, {1.0, 1.0, 0.3, 0.03, 0.003});
  sizes.smallest = spacing * one_of(random, {0.05, 0.2, 0.4, 0.6});
  if (sizes.octaves > 5 && sizes.share_large == 1.0) sizes.smallest *= std::ldexp(1.0, -4);
  if (sizes.octaves > 10) sizes.share_large = std::min(sizes.share_large, 0.003);
  return sizes;
}

Swarm swarm_in(Random& random, const Point& box, int dimensions, std::size_t members) {
  Swarm swarm;
  const double parts = one_of(random, {2, 2, 3, 4, 5});
  const bool in_one_place = random.uniform() < 0.2;
  const double relative =
      in_one_place ? random_scale(random, -52, -46) : random_scale(random, -16, -2);
  const double kind = random.uniform();
  double width = 0.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    // On or beside a face of a division into equal parts.
    swarm.center[axis] = box[axis] * (std::floor(random.uniform(0.0, parts + 1.0)) / parts);
    swarm.width[axis] = box[axis] * relative;
    if (random.uniform() < 0.15) swarm.width[axis] *= 0x1p-10;
    if (kind < 0.3) swarm.drift[axis] = box[axis] * random.uniform(-1.0, 1.0);
    if (kind < 0.15 && axis != 0) swarm.drift[axis] = 0.0;
    width = std::max({width, swarm.width[axis], 0.1 * std::fabs(swarm.drift[axis])});
  }
  swarm.even = random.uniform() < 0.5;
  const double along_axis =
      dimensions == 2 ? std::sqrt(static_cast<double>(members))
                      : std::ceil(0.1 + 0.1 * std::sqrt(static_cast<double>(members))) * 4.0;
  swarm.sizes = sizes_for(random, width / along_axis);
  return swarm;
}

Swarm background_of(Random& random, const Point& box, std::size_t members) {
  Swarm background;
  background.even = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    background.center[axis] = 0.5 * box[axis];
    background.width[axis] = box[axis];
  }
  background.sizes = sizes_for(random, box[0] / std::sqrt(static_cast<double>(members)));
  return background;
}

Point random_box(Random& random, int dimensions) {
  Point box{1.0, 1.0, dimensions == 3 ? 1.0 : 0.0};
  const double kind = random.uniform();
  if (kind < 0.25) box[random.below(static_cast<std::size_t>(dimensions))] *= 0x1p-6;
  if (kind > 0.85) box[random.below(static_cast<std::size_t>(dimensions))] *= 0x1p12;
  return box;
}

/// Makes the given box that of the system, so that its divisions are where the swarms are.
void confine(Scene& scene, const Point& box) {
  std::size_t axis = 0;
  for (std::vector<double>* numbers : {&scene.x, &scene.y, &scene.z}) {
    for (double& number : *numbers) number = std::clamp(number, 0.0, box[axis]);
    if (numbers->size() > 1) {
      numbers->front() = 0.0;
      numbers->back() = box[axis];
    }
    ++axis;
  }
}

/// Multiples of a power of two: distances tie with sums of radii.
void round_to(Scene& scene, double unit) {
  const auto round_all = [unit](std::vector<double>& numbers) {
    for (double& number : numbers) number = std::floor(number / unit) * unit;
  };
  round_all(scene.x);
  round_all(scene.y);
  round_all(scene.z);
  for (double& radius : scene.radius) radius = std::max(1.0, std::floor(radius / unit)) * unit;
}

void add(Scene& scene, const Point& center, double radius) {
  scene.x.push_back(center[0]);
  scene.y.push_back(center[1]);
  if (scene.dimensions == 3) scene.z.push_back(center[2]);
  scene.radius.push_back(radius);
}

}  // namespace

CrowdedSystem crowded_system(int dimensions, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  CrowdedSystem system;
  system.scene.dimensions = dimensions;
  const Point box = random_box(random, dimensions);
  std::vector<Swarm> swarms{background_of(random, box, count)};
  const std::size_t parts = 1 + random.below(5);
  for (std::size_t k = 0; k < parts; ++k) {
    swarms.push_back(swarm_in(random, box, dimensions, count / parts));
  }
  const double share_of_background = one_of(random, {0.02, 0.3, 0.8});
  for (std::size_t k = 0; k < count; ++k) {
    const bool in_background = random.uniform() < share_of_background;
    const Swarm& swarm = swarms[in_background ? 0 : 1 + random.below(parts)];
    const Point center = swarm.next(random);
    add(system.scene, center, swarm.sizes.next(random));
  }
  if (random.uniform() < 0.6) confine(system.scene, box);
  system.margin = one_of(random, {0.0, 0.0, 0.25, 2.0}) * swarms[1].sizes.smallest;
  if (random.uniform() < 0.3) {
    const double unit = std::ldexp(1.0, std::ilogb(swarms[1].sizes.smallest) - 1);
    round_to(system.scene, unit);
    system.margin = std::floor(system.margin / unit) * unit;
  }
  return system;
}

CrowdedSystem scaled(const CrowdedSystem& system, int exponent) {
  CrowdedSystem result = system;
  const auto scale = [exponent](std::vector<double>& numbers) {
    for (double& number : numbers) number = std::ldexp(number, exponent);
  };
  scale(result.scene.x);
  scale(result.scene.y);
  scale(result.scene.z);
  scale(result.scene.radius);
  result.margin = std::ldexp(result.margin, exponent);
  return result;
}

}  // namespace abut::testing
