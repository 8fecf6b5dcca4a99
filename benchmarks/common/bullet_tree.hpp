#pragma once

#include "benchmarks/common/bounds.hpp"

#include <abut/pair.hpp>

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <cstddef>

namespace abut::benchmarks {

/// Fills Bullet's btDbvt, a tree of boxes in float, box by box and walks it against itself. Calls
/// `take(a, b)` once for each two boxes that intersect. `side(k, axis)` gives the Bounds<double> of
/// box k on each of three axes, which are rounded outwards.
template <class Side, class Take>
void for_each_pair_of_bullet(std::size_t count, Side&& side, Take&& take) {
  struct Walk final : btDbvt::ICollide {
    explicit Walk(Take& to) : take(to) {}
    void Process(const btDbvtNode* a, const btDbvtNode* b) override {
      take(static_cast<ElementIndex>(a->dataAsInt), static_cast<ElementIndex>(b->dataAsInt));
    }
    Take& take;
  };

  btDbvt tree;
  for (std::size_t k = 0; k < count; ++k) {
    btVector3 low(0, 0, 0);
    btVector3 high(0, 0, 0);
    for (int axis = 0; axis < 3; ++axis) {
      const Bounds<float> bounds = float_bounds(side(k, static_cast<std::size_t>(axis)));
      low[axis] = bounds.low;
      high[axis] = bounds.high;
    }
    tree.insert(btDbvtVolume::FromMM(low, high), nullptr)->dataAsInt = static_cast<int>(k);
  }
  Walk walk(take);
  tree.collideTT(tree.m_root, tree.m_root, walk);
}

}  // namespace abut::benchmarks
