// Contacts with walls of a Detector.

#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "detect/detector_state.hpp"
#include "walls/mesh_search.hpp"
#include "walls/require_walls.hpp"

#include <abut/box_contacts.hpp>
#include <abut/detector.hpp>
#include <abut/mesh_contacts.hpp>

#include <memory>

namespace abut {
namespace walls {
namespace {

/// The memory of a Detector for walls.
struct DetectorWalls {
  MeshSearch mesh_search;
  MeshContactList mesh_contacts;
  BoxContactList box_contacts;
};

DetectorWalls& walls_of(std::shared_ptr<void>& kept) {
  if (!kept) kept = std::make_shared<DetectorWalls>();
  return *static_cast<DetectorWalls*>(kept.get());
}

/// Empties the arrays of a list unless they are kept.
class MeshArrayBuffers {
 public:
  explicit MeshArrayBuffers(const MeshContactArrays& arrays) : arrays_(arrays) {}
  ~MeshArrayBuffers() {
    if (is_kept_) return;
    arrays_.contacts.clear();
    arrays_.shifts.clear();
    arrays_.geometry = {};
  }
  MeshArrayBuffers(const MeshArrayBuffers&) = delete;
  MeshArrayBuffers& operator=(const MeshArrayBuffers&) = delete;

  void keep() noexcept { is_kept_ = true; }

 private:
  const MeshContactArrays& arrays_;
  bool is_kept_ = false;
};

/// Images, rules and the algorithms of the book are the business of a search for boxes.
bool is_for_grid(const Domain& domain, const Options& options) {
  return !domain.is_periodic() && options.rule.is_empty() &&
         (options.algorithm == Algorithm::automatic || options.algorithm == Algorithm::rows);
}

}  // namespace
}  // namespace walls

const MeshContactList& Detector::find_mesh_contacts(const ElementView& spheres,
                                                    const TriangleMesh& mesh,
                                                    const Domain& domain) {
  const base::FloatEnvironment environment;
  walls::DetectorWalls& walls = base::reporting_lack_of_memory(
      [&]() -> walls::DetectorWalls& { return walls::walls_of(state_->walls); });
  MeshContactList& list = walls.mesh_contacts;
  const walls::MeshContactArrays arrays{list.contacts_, list.shifts_, list.geometry_};
  walls::MeshArrayBuffers buffers(arrays);
  base::reporting_lack_of_memory([&] {
    walls::require_spheres(spheres);
    walls::require_its_domain(mesh, domain);
  });
  if (walls::is_for_grid(domain, state_->options)) {
    list.statistics_ = walls.mesh_search.find(spheres, mesh, state_->options, arrays);
  } else {
    list = abut::find_mesh_contacts(spheres, mesh, domain, state_->options);
  }
  buffers.keep();
  return list;
}

const BoxContactList& Detector::find_box_contacts(const ElementView& spheres,
                                                  const ElementView& boxes, const Domain& domain) {
  BoxContactList& list = base::reporting_lack_of_memory(
      [&]() -> BoxContactList& { return walls::walls_of(state_->walls).box_contacts; });
  list = {};
  list = abut::find_box_contacts(spheres, boxes, domain, state_->options);
  return list;
}

}  // namespace abut
