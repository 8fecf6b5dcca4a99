// FCL's DynamicAABBTreeCollisionManager: a tree of boxes around collision objects. The objects stay
// from run to run; their places and boxes, and the tree, are made anew.

#include "benchmarks/common/packed.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/config.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;
using Object = fcl::CollisionObject<double>;

class Fcl final : public Contestant {
 public:
  Answer run(const Scene& scene) override {
    packed_.pack(scene);
    place_objects();
    fcl::DynamicAABBTreeCollisionManager_Array<double> manager;
    manager.tree_init_level = 2;  // along a Morton curve, the fastest of its ways to build
    manager.registerObjects(pointers_);
    manager.setup();
    if (packed_.size() > 1) manager.collide(&packed_, take);
    return {packed_.pairs(), packed_.pairs().size()};
  }
  [[nodiscard]] Counters counters() const override { return {packed_.candidates(), 0, {}}; }

 private:
  static ElementIndex number_of(const Object* object) {
    return static_cast<ElementIndex>(reinterpret_cast<std::uintptr_t>(object->getUserData()));
  }

  static bool take(Object* a, Object* b, void* packed) {
    static_cast<Packed*>(packed)->propose(number_of(a), number_of(b));
    return false;
  }

  void place_objects() {
    while (objects_.size() < packed_.size()) {
      spheres_.push_back(std::make_shared<fcl::Sphere<double>>(1.0));
      objects_.push_back(std::make_unique<Object>(spheres_.back()));
      objects_.back()->setUserData(reinterpret_cast<void*>(objects_.size() - 1));
      pointers_.push_back(objects_.back().get());
    }
    for (std::size_t k = 0; k < packed_.size(); ++k) {
      const auto& center = packed_[k].center;
      double half = 0.0;  // of the widest side
      for (std::size_t axis = 0; axis < 3; ++axis) {
        half = std::max(half, bounds(packed_[k], axis).high - center[axis]);
      }
      spheres_[k]->radius = half;
      spheres_[k]->computeLocalAABB();
      objects_[k]->setTranslation({center[0], center[1], center[2]});
      objects_[k]->computeAABB();
    }
  }

  Packed packed_;
  std::vector<std::shared_ptr<fcl::Sphere<double>>> spheres_;
  std::vector<std::unique_ptr<Object>> objects_;
  std::vector<Object*> pointers_;
};

}  // namespace

std::vector<Entry> enter_fcl() {
  Entry entry = package_entry("fcl", "FCL " FCL_VERSION " dynamic AABB tree");
  entry.make = [] { return std::make_unique<Fcl>(); };
  return {entry};
}

}  // namespace abut::benchmarks
