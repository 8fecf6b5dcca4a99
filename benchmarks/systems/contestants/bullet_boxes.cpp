// Bullet's btDbvt: a tree of boxes in float, rounded outwards, filled box by box and walked against
// itself; what it proposes is compared in double.

#include "benchmarks/systems/box_contestant.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace abut::benchmarks {
namespace {

float below(double value) {
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) <= value
             ? rounded
             : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

btDbvtVolume volume_of(const scenes::BoxScene& scene, std::size_t k) {
  btVector3 low(0, 0, 0);
  btVector3 high(0, 0, 0);
  for (int axis = 0; axis < scene.dimensions; ++axis) {
    const auto column = static_cast<std::size_t>(axis);
    low[axis] = below(scene.lower[column][k]);
    high[axis] = -below(-scene.upper[column][k]);
  }
  return btDbvtVolume::FromMM(low, high);
}

class Bullet {
 public:
  const std::vector<ContactPair>& run(const scenes::BoxScene& scene) {
    Take take(scene);
    btDbvt tree;
    for (std::size_t k = 0; k < scene.size(); ++k) {
      tree.insert(volume_of(scene, k), nullptr)->dataAsInt = static_cast<int>(k);
    }
    take.pairs.swap(pairs_);
    take.pairs.clear();
    tree.collideTT(tree.m_root, tree.m_root, take);
    pairs_.swap(take.pairs);
    return pairs_;
  }

 private:
  struct Take final : btDbvt::ICollide {
    explicit Take(const scenes::BoxScene& boxes) : scene(boxes) {}

    void Process(const btDbvtNode* a, const btDbvtNode* b) override {
      const auto i = static_cast<std::size_t>(a->dataAsInt);
      const auto j = static_cast<std::size_t>(b->dataAsInt);
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
        if (scene.lower[axis][i] > scene.upper[axis][j]) return;
        if (scene.lower[axis][j] > scene.upper[axis][i]) return;
      }
      pairs.push_back(
          {static_cast<ElementIndex>(std::min(i, j)), static_cast<ElementIndex>(std::max(i, j))});
    }

    const scenes::BoxScene& scene;
    std::vector<ContactPair> pairs;
  };

  std::vector<ContactPair> pairs_;
};

}  // namespace

std::vector<BoxContestant> enter_bullet_boxes() {
  return {{"bullet_dbvt",
           [bullet = std::make_shared<Bullet>()](const scenes::BoxScene& scene)
               -> const std::vector<ContactPair>& { return bullet->run(scene); }}};
}

}  // namespace abut::benchmarks
