// Bullet's btDbvt: a tree of boxes in float, filled box by box, walked against itself.

#include "benchmarks/common/packed.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <LinearMath/btScalar.h>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

btDbvtVolume volume_of(const PackedElement& element) {
  const Bounds<float> x = float_bounds(element, 0);
  const Bounds<float> y = float_bounds(element, 1);
  const Bounds<float> z = float_bounds(element, 2);
  return btDbvtVolume::FromMM({x.low, y.low, z.low}, {x.high, y.high, z.high});
}

struct Take final : btDbvt::ICollide {
  explicit Take(Packed& to) : packed(to) {}
  void Process(const btDbvtNode* a, const btDbvtNode* b) override {
    packed.propose(static_cast<ElementIndex>(a->dataAsInt),
                   static_cast<ElementIndex>(b->dataAsInt));
  }
  Packed& packed;
};

class BulletDbvt final : public Contestant {
 public:
  Answer run(const Scene& scene) override {
    packed_.pack(scene);
    btDbvt tree;
    for (std::size_t k = 0; k < packed_.size(); ++k) {
      tree.insert(volume_of(packed_[k]), nullptr)->dataAsInt = static_cast<int>(k);
    }
    Take take(packed_);
    tree.collideTT(tree.m_root, tree.m_root, take);
    return {packed_.pairs(), packed_.pairs().size()};
  }
  [[nodiscard]] Counters counters() const override { return {packed_.candidates(), 0, {}}; }

 private:
  Packed packed_;
};

}  // namespace

std::vector<Entry> enter_bullet_dbvt() {
  constexpr int version = BT_BULLET_VERSION;
  Entry entry = package_entry("bullet_dbvt", "Bullet " + std::to_string(version / 100) + '.' +
                                                 std::to_string(version % 100) + " btDbvt");
  entry.make = [] { return std::make_unique<BulletDbvt>(); };
  return {entry};
}

}  // namespace abut::benchmarks
