// Bullet's btDbvt, whose boxes are in float; what it proposes is compared in double.

#include "benchmarks/common/bullet_tree.hpp"
#include "benchmarks/systems/box_contestant.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace abut::benchmarks {
namespace {

bool intersect(const scenes::BoxScene& scene, std::size_t i, std::size_t j) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
    if (scene.lower[axis][i] > scene.upper[axis][j]) return false;
    if (scene.lower[axis][j] > scene.upper[axis][i]) return false;
  }
  return true;
}

class Bullet {
 public:
  const std::vector<ContactPair>& run(const scenes::BoxScene& scene) {
    const auto side = [&](std::size_t k, std::size_t axis) {
      if (axis >= static_cast<std::size_t>(scene.dimensions)) return Bounds<double>{0.0, 0.0};
      return Bounds<double>{scene.lower[axis][k], scene.upper[axis][k]};
    };
    pairs_.clear();
    for_each_pair_of_bullet(scene.size(), side, [&](ElementIndex a, ElementIndex b) {
      if (intersect(scene, a, b)) pairs_.push_back({std::min(a, b), std::max(a, b)});
    });
    return pairs_;
  }

 private:
  std::vector<ContactPair> pairs_;
};

}  // namespace

std::vector<BoxContestant> enter_bullet_boxes() {
  return {{"bullet_dbvt",
           [bullet = std::make_shared<Bullet>()](const scenes::BoxScene& scene)
               -> const std::vector<ContactPair>& { return bullet->run(scene); }}};
}

}  // namespace abut::benchmarks
