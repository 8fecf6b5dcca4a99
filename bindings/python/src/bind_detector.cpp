#include "array_out.hpp"
#include "bind.hpp"
#include "call_options.hpp"
#include "elements.hpp"
#include "held_mesh.hpp"
#include "held_results.hpp"
#include "statistics_out.hpp"
#include "walls_out.hpp"

#include <abut/detector.hpp>
#include <abut/error.hpp>
#include <abut/skin.hpp>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace abut::python {

namespace {

/// Calls a function while other threads of Python run.
template <class Function>
decltype(auto) unlocked(Function&& function) {
  const nb::gil_scoped_release released;
  return function();
}

/// A detector whose lists Python may keep. Its memory serves again where no list nor array of the
/// last call lives any more.
class SharedDetector {
 public:
  SharedDetector() = default;
  SharedDetector(const SharedDetector&) = delete;
  SharedDetector& operator=(const SharedDetector&) = delete;
  /// Lists that Python still sees outlive the detector.
  ~SharedDetector() {
    release_pairs();
    release_neighbors();
  }

  std::shared_ptr<PairResults> find(const Elements& elements, const Elements* others,
                                    const Domain& domain, nb::object options) {
    const Call call(*this, std::move(options));
    release_pairs();
    const PairList& list = unlocked([&]() -> const PairList& {
      return others != nullptr
                 ? detector_.find_contact_pairs(elements.view(), others->view(), domain)
                 : detector_.find_contact_pairs(elements.view(), domain);
    });
    pairs_ = std::make_shared<PairResults>(&list);
    return pairs_;
  }

  std::shared_ptr<NeighborResults> build(const Elements& elements, const Elements* others,
                                         const Domain& domain, NeighborListKind kind,
                                         nb::object options) {
    const Call call(*this, std::move(options));
    release_neighbors();
    const NeighborList& list = unlocked([&]() -> const NeighborList& {
      return others != nullptr
                 ? detector_.build_neighbor_list(elements.view(), others->view(), domain)
                 : detector_.build_neighbor_list(elements.view(), domain, kind);
    });
    neighbors_ = std::make_shared<NeighborResults>(&list);
    return neighbors_;
  }

  /// The detector has one list of contacts with a mesh, so Python gets a copy, which it may keep.
  std::shared_ptr<WallResults<MeshContact>> find_on_mesh(const Elements& spheres, HeldMesh& mesh,
                                                         const Domain& domain, nb::object options) {
    const Call call(*this, std::move(options));
    const HeldMesh::Reading reading(mesh);
    return found<MeshContact>(
        [&] { return detector_.find_mesh_contacts(spheres.view(), mesh.mesh(), domain); });
  }

  /// Finds contacts with boxes; Python gets a copy of the list.
  std::shared_ptr<WallResults<BoxContact>> find_on_boxes(const Elements& spheres,
                                                         const Elements& boxes,
                                                         const Domain& domain, nb::object options) {
    const Call call(*this, std::move(options));
    return found<BoxContact>(
        [&] { return detector_.find_box_contacts(spheres.view(), boxes.view(), domain); });
  }

  nb::dict count(const Elements& elements, const Elements* others, const Domain& domain,
                 nb::object options) {
    const Call call(*this, std::move(options));
    return fields_of(unlocked([&] {
      return others != nullptr
                 ? detector_.count_contact_pairs(elements.view(), others->view(), domain)
                 : detector_.count_contact_pairs(elements.view(), domain);
    }));
  }

  /// The detector between two calls.
  Detector& at_rest() {
    require_rest();
    return detector_;
  }

 private:
  void release_pairs() noexcept {
    if (pairs_ && pairs_.use_count() > 1) pairs_->keep(detector_.take_pairs());
    pairs_.reset();
  }
  void release_neighbors() noexcept {
    if (neighbors_ && neighbors_.use_count() > 1) neighbors_->keep(detector_.take_neighbors());
    neighbors_.reset();
  }

  /// One call: sets the options, keeps the others out, and forgets the options at the end, since
  /// they look at objects of the caller.
  class Call {
   public:
    Call(SharedDetector& owner, nb::object options) : owner_(owner), options_(std::move(options)) {
      owner_.require_rest();
      owner_.detector_.set_options(nb::cast<const CallOptions&>(options_).of_call());
      owner_.is_busy_ = true;
    }
    ~Call() {
      owner_.is_busy_ = false;
      owner_.detector_.set_options({});
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    SharedDetector& owner_;
    nb::object options_;
  };

  void require_rest() const {
    if (!is_busy_) return;
    throw Error(ErrorCode::wrong_usage,
                "this detector is at work in another thread or further up in this one; a detector "
                "takes one call at a time, so make one for each thread");
  }

  Detector detector_;
  std::shared_ptr<PairResults> pairs_;
  std::shared_ptr<NeighborResults> neighbors_;
  bool is_busy_ = false;  ///< read and written under the interpreter's lock
};

NeighborListKind kind_of(bool full) {
  return full ? NeighborListKind::full : NeighborListKind::half;
}

/// Sets the skin: none unless there is a length or it is automatic.
void set_skin(SharedDetector& detector, std::optional<double> length, bool automatic) {
  Skin skin = Skin::none();
  if (automatic) skin = Skin::automatic();
  if (length) skin = Skin::fixed(*length);
  detector.at_rest().set_skin(skin);
}

void set_ids(SharedDetector& detector, nb::handle ids) {
  if (ids.is_none()) return detector.at_rest().set_ids({});
  const NumberBuffer buffer(ids);
  detector.at_rest().set_ids(whole_numbers_of<std::uint64_t>(buffer));
}

nb::dict skin_statistics(SharedDetector& detector) {
  const SkinStatistics& statistics = detector.at_rest().skin_statistics();
  nb::dict fields;
  fields["detections"] = statistics.detections;
  fields["reuses"] = statistics.reuses;
  fields["carried"] = statistics.carried;
  fields["inserted"] = statistics.inserted;
  fields["candidates"] = statistics.candidates;
  fields["survivors"] = statistics.survivors;
  fields["skin"] = statistics.skin;
  fields["approach"] = statistics.approach;
  return fields;
}

}  // namespace

void bind_detector(nb::module_& module) {
  nb::class_<SharedDetector>(module, "Detector")
      .def(nb::init<>())
      .def("find_contact_pairs", &SharedDetector::find, nb::arg("elements"),
           nb::arg("others").none(), nb::arg("domain"), nb::arg("options"))
      .def("count_contact_pairs", &SharedDetector::count, nb::arg("elements"),
           nb::arg("others").none(), nb::arg("domain"), nb::arg("options"))
      .def(
          "build_neighbor_list",
          [](SharedDetector& detector, const Elements& elements, const Elements* others,
             const Domain& domain, bool full, nb::object options) {
            return detector.build(elements, others, domain, kind_of(full), std::move(options));
          },
          nb::arg("elements"), nb::arg("others").none(), nb::arg("domain"), nb::arg("full"),
          nb::arg("options"))
      .def("find_mesh_contacts", &SharedDetector::find_on_mesh, nb::arg("spheres"), nb::arg("mesh"),
           nb::arg("domain"), nb::arg("options"))
      .def("find_box_contacts", &SharedDetector::find_on_boxes, nb::arg("spheres"),
           nb::arg("boxes"), nb::arg("domain"), nb::arg("options"))
      .def("set_skin", &set_skin, nb::arg("length").none(), nb::arg("automatic"))
      .def("set_ids", &set_ids, nb::arg("ids").none())
      .def_prop_ro("skin_statistics", &skin_statistics);
}

}  // namespace abut::python
