#include "periodic/periodic_run.hpp"

#include "elements/lattice_of.hpp"
#include "periodic/periodic_rows.hpp"
#include "support/box_oracle.hpp"

#include <abut/detect.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <span>

namespace abut::testing {
namespace {

/// Keeps pairs with their shifts in their `as_found` order.
class KeptImagePairs final : public base::PairSink {
 public:
  void expect_workers(std::size_t count) override { workers_.resize(count); }
  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) override {
    workers_[worker].pairs.resize(smallest_buffer);
    return workers_[worker].pairs;
  }
  [[nodiscard]] std::span<ImageShift> shift_buffer(std::size_t worker) override {
    workers_[worker].shifts.resize(smallest_buffer);
    return workers_[worker].shifts;
  }
  void commit(std::size_t count, const base::Origin& origin) override {
    const std::lock_guard lock(mutex_);
    const auto& [pairs, shifts] = workers_[origin.worker];
    auto& of_unit = by_unit_[origin.unit];
    for (std::size_t k = 0; k < count; ++k) {
      of_unit.push_back(canonical(pairs[k].first, pairs[k].second, shifts[k]));
    }
  }

  [[nodiscard]] std::vector<FoundPair> pairs() const {
    std::vector<FoundPair> all;
    for (const auto& [unit, pairs] : by_unit_) all.insert(all.end(), pairs.begin(), pairs.end());
    return all;
  }

 private:
  struct Buffers {
    std::vector<ContactPair> pairs;
    std::vector<ImageShift> shifts;
  };

  std::mutex mutex_;
  std::vector<Buffers> workers_;
  std::map<std::uint64_t, std::vector<FoundPair>> by_unit_;
};

/// Runs `search` with all that a search needs, of spheres with these bounds, or of boxes.
template <int Dim, class Search>
std::optional<PeriodicRun> run(const Domain& domain, const Boxes<Dim>& boxes,
                               const grid::Bounds<Dim>& bounds,
                               const engine::RowsSettings& settings, const Search& search) {
  const exact::Lattice lattice = elements::lattice_of(domain);
  base::DetectionContext context;
  engine::Workspace<Dim> workspace(context.memory);
  periodic::PeriodicWorkspace<Dim> own(context.memory);
  KeptImagePairs sink;
  if (!search(periodic::PeriodicInput<Dim>{boxes, bounds, lattice, settings}, workspace, own, sink,
              context)) {
    return std::nullopt;
  }
  const engine::LastSearch& last = workspace.last;
  return PeriodicRun{sink.pairs(),
                     context.exact_decisions,
                     last.most_in_layers,
                     last.in_plane,
                     last.clusters_moved,
                     last.beside_layers,
                     last.levels_of_sizes,
                     workspace.layer_crowds.layers().size(),
                     own.images.ghosts().size()};
}

/// Of spheres with these bounds, or of boxes for which they stand.
template <int Dim>
std::optional<PeriodicRun> run_packed(const Domain& domain, const Boxes<Dim>& boxes,
                                      const Spheres<Dim>& spheres, const grid::Bounds<Dim>& bounds,
                                      const engine::RowsSettings& settings) {
  return run(domain, boxes, bounds, settings,
             [&](const auto& input, auto& workspace, auto& own, auto& sink, auto& context) {
               auto packed = array_of(spheres, context.memory);
               return periodic::periodic_rows<Dim>(packed, input, workspace, own, sink, context);
             });
}

std::vector<FoundPair> checked_directly(const ElementView& view, const Domain& domain,
                                        double margin) {
  const PairList list = find_contact_pairs(
      view, domain,
      {.algorithm = Algorithm::direct_check, .shifts = Shifts::stored, .margin = margin});
  std::vector<FoundPair> pairs;
  for (std::size_t k = 0; k < list.size(); ++k) {
    pairs.push_back(canonical(list[k].first, list[k].second, list.shifts()[k]));
  }
  return in_order(std::move(pairs));
}

}  // namespace

template <int Dim>
SpheresInDomain<Dim> spheres_in(const scenes::Scene& scene, const Domain& domain, double margin) {
  const std::array columns{&scene.x, &scene.y, &scene.z};
  SpheresInDomain<Dim> system{{}, domain, margin};
  for (std::size_t k = 0; k < scene.size(); ++k) {
    exact::Sphere<Dim> sphere{};
    for (std::size_t axis = 0; axis < Dim; ++axis) sphere.center[axis] = (*columns[axis])[k];
    sphere.radius = scene.radius[k];
    system.spheres.push_back(sphere);
  }
  return system;
}

template <int Dim>
BoxesInDomain<Dim> boxes_in(const scenes::BoxScene& scene, const Domain& domain, double margin) {
  BoxesInDomain<Dim> system{{}, domain, margin};
  for (std::size_t k = 0; k < scene.size(); ++k) {
    exact::Box<Dim> box{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      box.lower[axis] = scene.lower[axis][k];
      box.upper[axis] = scene.upper[axis][k];
    }
    system.boxes.push_back(box);
  }
  return system;
}

template <int Dim>
std::optional<PeriodicRun> run_periodic(const SpheresInDomain<Dim>& system,
                                        const engine::RowsSettings& settings) {
  return run_packed<Dim>(system.domain, {}, system.spheres, bounds_of<Dim>(system.spheres),
                         settings);
}

template <int Dim>
std::optional<PeriodicRun> run_periodic(const BoxesInDomain<Dim>& system,
                                        const engine::RowsSettings& settings) {
  return run_packed<Dim>(system.domain, system.boxes, stand_ins<Dim>(system.boxes),
                         bounds_of_boxes<Dim>(system.boxes), settings);
}

template <int Dim>
std::optional<PeriodicRun> run_periodic_in_place(const SpheresInDomain<Dim>& system,
                                                 const engine::RowsSettings& settings) {
  return run<Dim>(system.domain, {}, bounds_of<Dim>(system.spheres), settings,
                  [&](const auto& input, auto& workspace, auto& own, auto& sink, auto& context) {
                    const auto columns = kernels::strided_spheres(std::span(system.spheres));
                    return periodic::periodic_rows_in_place<Dim>(columns, input, workspace, own,
                                                                 sink, context);
                  });
}

std::vector<FoundPair> in_order(std::vector<FoundPair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <int Dim>
std::vector<FoundPair> checked_directly(const SpheresInDomain<Dim>& system) {
  std::array<std::vector<double>, 3> columns;
  std::vector<double> radii;
  for (const auto& sphere : system.spheres) {
    for (std::size_t axis = 0; axis < Dim; ++axis) columns[axis].push_back(sphere.center[axis]);
    radii.push_back(sphere.radius);
  }
  const auto& [x, y, z] = columns;
  const ElementView view = Dim == 2 ? discs(x, y, radii) : spheres(x, y, z, radii);
  return checked_directly(view, system.domain, system.margin);
}

template <int Dim>
std::vector<FoundPair> checked_directly(const BoxesInDomain<Dim>& system) {
  scenes::BoxScene scene;
  scene.dimensions = Dim;
  for (const exact::Box<Dim>& box : system.boxes) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      scene.lower[axis].push_back(box.lower[axis]);
      scene.upper[axis].push_back(box.upper[axis]);
    }
  }
  return checked_directly(view_of(scene), system.domain, system.margin);
}

template SpheresInDomain<2> spheres_in(const scenes::Scene&, const Domain&, double);
template SpheresInDomain<3> spheres_in(const scenes::Scene&, const Domain&, double);
template BoxesInDomain<2> boxes_in(const scenes::BoxScene&, const Domain&, double);
template BoxesInDomain<3> boxes_in(const scenes::BoxScene&, const Domain&, double);
template std::optional<PeriodicRun> run_periodic(const SpheresInDomain<2>&,
                                                 const engine::RowsSettings&);
template std::optional<PeriodicRun> run_periodic(const SpheresInDomain<3>&,
                                                 const engine::RowsSettings&);
template std::optional<PeriodicRun> run_periodic_in_place(const SpheresInDomain<2>&,
                                                          const engine::RowsSettings&);
template std::optional<PeriodicRun> run_periodic_in_place(const SpheresInDomain<3>&,
                                                          const engine::RowsSettings&);
template std::optional<PeriodicRun> run_periodic(const BoxesInDomain<2>&,
                                                 const engine::RowsSettings&);
template std::optional<PeriodicRun> run_periodic(const BoxesInDomain<3>&,
                                                 const engine::RowsSettings&);
template std::vector<FoundPair> checked_directly(const BoxesInDomain<2>&);
template std::vector<FoundPair> checked_directly(const BoxesInDomain<3>&);
template std::vector<FoundPair> checked_directly(const SpheresInDomain<2>&);
template std::vector<FoundPair> checked_directly(const SpheresInDomain<3>&);

}  // namespace abut::testing
