#include "properties/systems.hpp"

#include "support/scene_view.hpp"

#include <algorithm>
#include <cstdlib>

namespace abut::testing {
namespace {

Scene rounded_to_float(const Scene& scene) {
  return Float32Scene(scene).widened;
}

}  // namespace

rc::Gen<Scene> system_on(double unit, int most) {
  return rc::gen::exec([unit, most] {
    const int dimensions = *rc::gen::element(2, 3);
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(0, most + 1));
    const auto steps = *rc::gen::container<std::vector<int>>(4 * count, rc::gen::inRange(-12, 13));
    Scene scene;
    scene.dimensions = dimensions;
    for (std::size_t k = 0; k < count; ++k) {
      scene.x.push_back(steps[4 * k] * unit);
      scene.y.push_back(steps[4 * k + 1] * unit);
      if (dimensions == 3) scene.z.push_back(steps[4 * k + 2] * unit);
      scene.radius.push_back((std::abs(steps[4 * k + 3]) % 5) * unit);
    }
    return scene;
  });
}

rc::Gen<Scene> any_system() {
  const auto units = rc::gen::element(exact_unit, 0.1, 0x1.6a09e667f3bcdp-1);
  return rc::gen::mapcat(rc::gen::pair(units, rc::gen::arbitrary<bool>()), [](const auto& drawn) {
    const auto [unit, rounded] = drawn;
    return rounded ? rc::gen::map(system_on(unit), rounded_to_float) : system_on(unit);
  });
}

std::vector<std::vector<double>*> axes_of(Scene& scene) {
  std::vector<std::vector<double>*> axes{&scene.x, &scene.y};
  if (scene.dimensions == 3) axes.push_back(&scene.z);
  return axes;
}

PairVector renumbered(const PairVector& pairs, const std::vector<std::size_t>& new_number) {
  PairVector result;
  for (const ContactPair& pair : pairs) {
    const auto [first, second] = std::minmax(new_number[pair.first], new_number[pair.second]);
    result.push_back({static_cast<ElementIndex>(first), static_cast<ElementIndex>(second)});
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace abut::testing
