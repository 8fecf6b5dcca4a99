#include "base/callers_exception.hpp"
#include "base/detection_context.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/memory_meter.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "elements/gathered_elements.hpp"
#include "geometry/spans.hpp"
#include "kernels/simd_level.hpp"
#include "walls/box_measurer.hpp"
#include "walls/feature_measurer.hpp"
#include "walls/measure_contacts.hpp"
#include "walls/require_walls.hpp"

#include <abut/box_contacts.hpp>
#include <abut/error.hpp>
#include <abut/mesh_contacts.hpp>

#include <cstddef>
#include <string>

namespace abut {
namespace {

void require_there(std::size_t number, std::size_t count, const char* what) {
  if (number < count) return;
  throw Error(ErrorCode::wrong_usage, "a contact names " + std::string(what) + " " +
                                          std::to_string(number) + ", but there are " +
                                          std::to_string(count) + ", numbered from 0");
}

void require_there(const TriangleMesh& mesh, MeshFeature feature) {
  switch (feature.kind) {
    case FeatureKind::vertex:
      return require_there(feature.number, mesh.vertices().size(), "vertex");
    case FeatureKind::edge:
      return require_there(feature.number, mesh.edges().size(), "edge");
    case FeatureKind::face:
      return require_there(feature.number, mesh.size(), "face");
    default:
      throw Error(ErrorCode::wrong_usage, "a contact names the interior of a mesh, which has none");
  }
}

/// The needs of one call of `measure`: spheres that were read and checked, and workers.
template <int Dim, class Contact>
class WallMeasurer {
 public:
  WallMeasurer(const ElementView& spheres, const ContactSpans<Contact>& contacts,
               const Domain& domain, const Options& options)
      : contacts_(contacts),
        memory_(detect::memory_bound(options)),
        context_(memory_, options.progress),
        workers_(base::worker_count(options.threads, spheres.size())),
        simd_(kernels::level_to_run(options.simd)),
        spheres_(memory_) {
    detect::validate(options, spheres, domain);
    geometry::require_shifts(contacts.contacts.size(), "contacts", contacts.shifts, domain);
    for (const Contact& contact : contacts.contacts) {
      require_there(contact.sphere, spheres.size(), "sphere");
    }
    gather(spheres, spheres_);
  }

  /// Reads and checks elements.
  void gather(const ElementView& elements, elements::GatheredElements<Dim>& gathered) {
    context_.progress.begin("gather", elements.size());
    elements::gather<Dim>(elements, {workers_, simd_}, gathered, context_);
  }

  /// Fills the arrays with the geometry of contacts.
  template <class Measurer>
  void measure(const PairGeometrySpans& geometry, const Measurer& measurer) {
    context_.progress.begin("measure", contacts_.contacts.size());
    const walls::WallContacts<Measurer, Contact> given{measurer, contacts_.contacts,
                                                       contacts_.shifts, workers_, simd_};
    walls::measure_contacts(given, geometry, context_.work,
                            [&](ElementIndex number) { return spheres_.spheres[number]; });
  }

  [[nodiscard]] base::MemoryMeter& memory() noexcept { return memory_; }

 private:
  const ContactSpans<Contact>& contacts_;
  base::MemoryMeter memory_;
  base::DetectionContext context_;
  std::size_t workers_;
  Simd simd_;
  elements::GatheredElements<Dim> spheres_;
};

template <int Dim>
void measure_boxes(const ElementView& spheres, const ElementView& boxes,
                   const ContactSpans<BoxContact>& contacts, const PairGeometrySpans& geometry,
                   const Domain& domain, const Options& options) {
  WallMeasurer<Dim, BoxContact> measurer(spheres, contacts, domain, options);
  elements::GatheredElements<Dim> checked(measurer.memory());
  measurer.gather(boxes, checked);
  measurer.measure(geometry, walls::BoxMeasurer<Dim>(boxes, domain));
}

template <class Body>
void guarded(Body&& body) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] { base::letting_through(body); });
}

}  // namespace

void measure(const ElementView& spheres, const TriangleMesh& mesh,
             const ContactSpans<MeshContact>& contacts, const PairGeometrySpans& geometry,
             const Domain& domain, const Options& options) {
  guarded([&] {
    walls::require_spheres(spheres);
    walls::require_its_domain(mesh, domain);
    geometry::require_lengths(contacts.contacts.size(), "contacts", contacts.shifts, geometry);
    for (const MeshContact& contact : contacts.contacts) require_there(mesh, contact.feature);
    WallMeasurer<3, MeshContact> measurer(spheres, contacts, domain, options);
    measurer.measure(geometry, walls::FeatureMeasurer(mesh, domain));
  });
}

void measure(const ElementView& spheres, const ElementView& boxes,
             const ContactSpans<BoxContact>& contacts, const PairGeometrySpans& geometry,
             const Domain& domain, const Options& options) {
  guarded([&] {
    walls::require_spheres_and_boxes(spheres, boxes);
    geometry::require_lengths(contacts.contacts.size(), "contacts", contacts.shifts, geometry);
    for (const BoxContact& contact : contacts.contacts) {
      require_there(contact.box, boxes.size(), "box");
    }
    spheres.dimensions() == 2
        ? measure_boxes<2>(spheres, boxes, contacts, geometry, domain, options)
        : measure_boxes<3>(spheres, boxes, contacts, geometry, domain, options);
  });
}

PairGeometry measure(const ElementView& spheres, const TriangleMesh& mesh,
                     const ContactSpans<MeshContact>& contacts, Quantities quantities,
                     const Domain& domain, const Options& options) {
  return base::reporting_lack_of_memory([&] {
    PairGeometry geometry = geometry::arrays_for(contacts.contacts.size(), quantities);
    measure(spheres, mesh, contacts, geometry.spans(), domain, options);
    return geometry;
  });
}

PairGeometry measure(const ElementView& spheres, const ElementView& boxes,
                     const ContactSpans<BoxContact>& contacts, Quantities quantities,
                     const Domain& domain, const Options& options) {
  return base::reporting_lack_of_memory([&] {
    PairGeometry geometry = geometry::arrays_for(contacts.contacts.size(), quantities);
    measure(spheres, boxes, contacts, geometry.spans(), domain, options);
    return geometry;
  });
}

}  // namespace abut
