#pragma once

#include "scenes/scene.hpp"

#include <abut/element_view.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace abut::testing {

[[nodiscard]] inline ElementView view_of(const scenes::Scene& scene) {
  return scene.dimensions == 2 ? discs(scene.x, scene.y, scene.radius)
                               : spheres(scene.x, scene.y, scene.z, scene.radius);
}

/// A scene rounded to float32, and the same numbers as doubles for the oracle.
class Float32Scene {
 public:
  explicit Float32Scene(const scenes::Scene& scene) {
    widened.dimensions = scene.dimensions;
    round(scene.x, x_, widened.x);
    round(scene.y, y_, widened.y);
    round(scene.z, z_, widened.z);
    round(scene.radius, radius_, widened.radius);
  }

  [[nodiscard]] ElementView view() const {
    return widened.dimensions == 2 ? discs(x_, y_, radius_) : spheres(x_, y_, z_, radius_);
  }

  scenes::Scene widened;

 private:
  static void round(const std::vector<double>& from, std::vector<float>& to,
                    std::vector<double>& widened_to) {
    for (const double number : from) {
      to.push_back(static_cast<float>(number));
      widened_to.push_back(static_cast<double>(to.back()));
    }
  }

  std::vector<float> x_, y_, z_, radius_;
};

/// Whether all numbers of a scene are floats, so that rounding it changes none.
[[nodiscard]] inline bool fits_float(const scenes::Scene& scene) {
  const auto is_float = [](double number) {
    return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()) &&
           static_cast<double>(static_cast<float>(number)) == number;
  };
  return std::ranges::all_of(
      std::array{&scene.x, &scene.y, &scene.z, &scene.radius},
      [&](const std::vector<double>* column) { return std::ranges::all_of(*column, is_float); });
}

/// Short scenes written by hand: one braced list an element.
struct HandMade {
  double x, y, z, radius;
};
[[nodiscard]] inline scenes::Scene scene_of(int dimensions, const std::vector<HandMade>& elements) {
  scenes::Scene scene;
  scene.dimensions = dimensions;
  for (const HandMade& e : elements) {
    scene.x.push_back(e.x);
    scene.y.push_back(e.y);
    if (dimensions == 3) scene.z.push_back(e.z);
    scene.radius.push_back(e.radius);
  }
  return scene;
}

/// The part of a scene whose numbers are given, in that order.
[[nodiscard]] inline scenes::Scene part_of(const scenes::Scene& scene,
                                           const std::vector<std::size_t>& numbers) {
  scenes::Scene part;
  part.dimensions = scene.dimensions;
  for (const std::size_t k : numbers) {
    part.x.push_back(scene.x[k]);
    part.y.push_back(scene.y[k]);
    if (scene.dimensions == 3) part.z.push_back(scene.z[k]);
    part.radius.push_back(scene.radius[k]);
  }
  return part;
}

}  // namespace abut::testing
