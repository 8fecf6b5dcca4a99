// Bullet's btDbvt: a tree of boxes in float, filled box by box, walked against itself.

#include "benchmarks/common/bullet_tree.hpp"
#include "benchmarks/common/packed.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <LinearMath/btScalar.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

class BulletDbvt final : public Contestant {
 public:
  Answer run(const Scene& scene) override {
    packed_.pack(scene);
    for_each_pair_of_bullet(
        packed_.size(), [&](std::size_t k, std::size_t axis) { return bounds(packed_[k], axis); },
        [&](ElementIndex a, ElementIndex b) { packed_.propose(a, b); });
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
