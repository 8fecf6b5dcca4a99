// Embree's rtcCollide: a hierarchy of boxes in float, walked against itself. Two ways to build it:
// along a Morton curve, the fast one, or by the surface-area heuristic.

#include "benchmarks/common/packed.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <embree3/rtcore.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

/// Releases what Embree counts references of.
template <class Handle, void (*Release)(Handle)>
class Owned {
 public:
  explicit Owned(Handle handle) : handle_(handle) {}
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { Release(handle_); }
  [[nodiscard]] Handle get() const { return handle_; }

 private:
  Handle handle_;
};

using Device = Owned<RTCDevice, rtcReleaseDevice>;
using Geometry = Owned<RTCGeometry, rtcReleaseGeometry>;
using Hierarchy = Owned<RTCScene, rtcReleaseScene>;

void give_bounds(const RTCBoundsFunctionArguments* arguments) {
  const Packed& packed = *static_cast<const Packed*>(arguments->geometryUserPtr);
  const PackedElement& element = packed[arguments->primID];
  const Bounds<float> x = float_bounds(element, 0);
  const Bounds<float> y = float_bounds(element, 1);
  const Bounds<float> z = float_bounds(element, 2);
  *arguments->bounds_o = {x.low, y.low, z.low, 0.0F, x.high, y.high, z.high, 0.0F};
}

/// Embree proposes both orders of each pair, and each element with itself.
void take(void* user, RTCCollision* collisions, unsigned int count) {
  Packed& packed = *static_cast<Packed*>(user);
  for (unsigned int k = 0; k < count; ++k) {
    if (collisions[k].primID0 < collisions[k].primID1) {
      packed.propose(collisions[k].primID0, collisions[k].primID1);
    }
  }
}

class Embree final : public Contestant {
 public:
  explicit Embree(RTCBuildQuality quality)
      : quality_(quality), device_(rtcNewDevice("threads=1,set_affinity=0")) {
    if (device_.get() == nullptr) throw std::runtime_error("Embree opens no device");
  }

  Answer run(const Scene& scene) override {
    packed_.pack(scene);
    if (packed_.size() > 0) search();
    return {packed_.pairs(), packed_.pairs().size()};
  }
  [[nodiscard]] Counters counters() const override { return {packed_.candidates(), 0, {}}; }

 private:
  void search() {
    const Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned int>(packed_.size()));
    rtcSetGeometryUserData(geometry.get(), &packed_);
    rtcSetGeometryBuildQuality(geometry.get(), quality_);
    rtcSetGeometryBoundsFunction(geometry.get(), give_bounds, nullptr);
    rtcCommitGeometry(geometry.get());
    const Hierarchy hierarchy(rtcNewScene(device_.get()));
    rtcSetSceneBuildQuality(hierarchy.get(), quality_);
    rtcSetSceneFlags(hierarchy.get(), RTC_SCENE_FLAG_ROBUST);
    rtcAttachGeometryByID(hierarchy.get(), geometry.get(), 0);
    rtcCommitScene(hierarchy.get());
    rtcCollide(hierarchy.get(), hierarchy.get(), take, &packed_);
    if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) {
      throw std::runtime_error("Embree reports an error");
    }
  }

  RTCBuildQuality quality_;
  Device device_;
  Packed packed_;
};

Entry entry_of(const std::string& name, const std::string& build, RTCBuildQuality quality) {
  Entry entry = package_entry(name, "Embree " RTC_VERSION_STRING " rtcCollide, " + build);
  entry.make = [quality] { return std::make_unique<Embree>(quality); };
  return entry;
}

}  // namespace

std::vector<Entry> enter_embree() {
  return {entry_of("embree_morton", "Morton build", RTC_BUILD_QUALITY_LOW),
          entry_of("embree_sah", "SAH build", RTC_BUILD_QUALITY_MEDIUM)};
}

}  // namespace abut::benchmarks
