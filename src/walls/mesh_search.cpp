#include "walls/mesh_search.hpp"

#include "base/asking_workers.hpp"
#include "base/callers_exception.hpp"
#include "base/lack_of_memory.hpp"
#include "base/stopwatch.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "kernels/simd_level.hpp"
#include "lists/result_buffer.hpp"
#include "walls/feature_measurer.hpp"
#include "walls/measure_contacts.hpp"
#include "walls/near_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace abut::walls {
namespace {

constexpr std::uint64_t steps_of_candidate = 64;

/// Shares of the reach by which the grid reaches farther than is needed: one that costs next to
/// nothing, so that radii may grow a little, and half where a mesh has been found to change its
/// shape.
constexpr double slack_of_grid = 1.0 / 64.0;
constexpr double slack_of_deforming_mesh = 0.5;

template <class T>
bool are_same(std::span<const T> a, const base::Array<T>& b) noexcept {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

template <class T>
void assign(std::span<const T> from, base::Array<T>& to) {
  base::resize_for_overwrite(to, from.size());
  std::copy(from.begin(), from.end(), to.begin());
}

/// Tells whether the frame lengthens distances by little enough to be used. Rounding makes no
/// rotation fail this; a mesh whose motion is none is looked for where it is.
bool is_usable(const RestFrame& frame, double reach) noexcept {
  return frame.reach_at_rest(reach) <= 1.125 * reach;
}

}  // namespace

Statistics MeshSearch::find(const ElementView& spheres, const TriangleMesh& mesh,
                            const Options& options, const MeshContactArrays& arrays) {
  base::reporting_lack_of_memory([&] { detect::validate(options, spheres, Domain::open()); });
  memory_.start_anew(detect::memory_bound(options));
  base::DetectionContext context(memory_, options.progress);
  return base::letting_through([&] {
    return base::reporting_lack_of_memory(memory_, [&] {
      const Call call{spheres, mesh, options, context,
                      base::worker_count(options.threads, spheres.size())};
      while (scratch_.size() < call.workers) scratch_.emplace_back(memory_);
      Statistics statistics;
      base::Stopwatch stopwatch;
      find_all(call);
      statistics.search_seconds = stopwatch.lap();
      write(call, arrays, statistics);
      statistics.order_seconds = stopwatch.lap();
      measure(call, arrays, statistics);
      if (options.shifts == Shifts::none) arrays.shifts.clear();
      statistics.peak_bytes = memory_.peak();
      statistics.working_bytes = memory_.working_peak();
      return statistics;
    });
  });
}

/// The radii are known only when the spheres have been read: it searches with a grid for those of
/// the last call, and again if it was too small.
void MeshSearch::find_all(const Call& call) {
  if (!is_grid_of(call.mesh)) reach_of_grid_ = -1.0;
  if (reach_of_grid_ < 0.0) {
    last_radius_ = largest_radius(call);
    build(call);
  } else if (!reaches(frame_of(call.mesh), call)) {
    build(call);
  }
  const RestFrame frame = frame_of(call.mesh);
  last_radius_ = search(call, frame);
  if (reaches(frame, call)) return;
  build(call);
  search(call, frame_of(call.mesh));
}

/// Tells whether the grid reaches far enough for spheres of the largest radius that is known.
bool MeshSearch::reaches(const RestFrame& frame, const Call& call) const noexcept {
  return frame.reach_at_rest(reach_of(call)) <= reach_of_grid_;
}

double MeshSearch::reach_of(const Call& call) const noexcept {
  return std::min(last_radius_ + call.options.margin, std::numeric_limits<double>::max());
}

/// Vertices may have changed; `frame_of` tells how far.
bool MeshSearch::is_grid_of(const TriangleMesh& mesh) const noexcept {
  return are_same(mesh.triangles(), triangles_) && mesh.vertices().size() == anchor_.size();
}

RestFrame MeshSearch::frame_of(const TriangleMesh& mesh) const noexcept {
  if (is_anchored_at_rest_) {
    return RestFrame(mesh, largest_displacement(mesh.rest_vertices(), anchor_));
  }
  return RestFrame::of_place(largest_displacement(mesh.vertices(), anchor_));
}

void MeshSearch::build(const Call& call) {
  const TriangleMesh& mesh = call.mesh;
  const double reach = reach_of(call);
  call.context.progress.begin("walls", mesh.size());
  const bool is_changed_shape =
      reach_of_grid_ >= 0.0 && is_grid_of(mesh) &&
      !are_same(is_anchored_at_rest_ ? mesh.rest_vertices() : mesh.vertices(), anchor_);
  reach_of_grid_ = -1.0;
  const RestFrame at_rest(mesh, 0.0);
  is_anchored_at_rest_ = is_usable(at_rest, reach);
  const auto vertices = is_anchored_at_rest_ ? mesh.rest_vertices() : mesh.vertices();
  assign(vertices, anchor_);
  assign(mesh.triangles(), triangles_);
  const double needed = frame_of(mesh).reach_at_rest(reach);
  const double slack = is_changed_shape ? slack_of_deforming_mesh : slack_of_grid;
  const double wide = std::min(needed * (1.0 + slack), std::numeric_limits<double>::max());
  grid_.build(mesh.size(), wide, call.context.work,
              [&](std::size_t k) { return box_around(triangles_[k]); });
  lay_planes(wide);
  reach_of_grid_ = wide;  // last: whatever failed before leaves no grid
  ++builds_;
}

exact::Box<3> MeshSearch::box_around(const TriangleMesh::Corners& corners) const noexcept {
  exact::Box<3> box{};
  const auto& [a, b, c] = corners;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lower, upper] = std::minmax({anchor_[a][axis], anchor_[b][axis], anchor_[c][axis]});
    box.lower[axis] = lower;
    box.upper[axis] = upper;
  }
  return box;
}

double MeshSearch::largest_radius(const Call& call) {
  call.context.progress.begin("gather", call.spheres.size());
  for_each_block(call, [](std::span<const exact::Sphere<3>>, std::size_t, SearchScratch&) {});
  return largest_of_workers(call);
}

double MeshSearch::largest_of_workers(const Call& call) const noexcept {
  double largest = 0.0;
  for (std::size_t k = 0; k < call.workers; ++k) {
    largest = std::max(largest, scratch_[k].largest_radius);
  }
  return largest;
}

/// Calls act(block, number of its first sphere, scratch) for each block of a worker's share.
template <class Act>
void MeshSearch::for_each_block(const Call& call, Act&& act) {
  const elements::SphereReader reader(call.spheres, kernels::level_to_run(call.options.simd));
  for (SearchScratch& scratch : scratch_) scratch.start_anew();
  base::for_each_share(
      call.workers, call.context.work, [&](std::size_t worker, base::WorkCounter& work) {
        std::array<exact::Sphere<3>, block_size> block;
        const auto [first, last] = base::share_of(worker, call.workers, call.spheres.size());
        SearchScratch& scratch = scratch_[worker];
        for (std::size_t begin = first; begin < last; begin += block_size) {
          const std::span<exact::Sphere<3>> some(block.data(), std::min(block_size, last - begin));
          scratch.largest_radius = std::max(scratch.largest_radius, reader.read(begin, some));
          const std::uint64_t tests = scratch.tests;
          act(std::span<const exact::Sphere<3>>(some), begin, scratch);
          call.context.progress.advance(some.size());
          work.did(2 * some.size() + steps_of_candidate * (scratch.tests - tests));
        }
      });
}

/// Returns the largest radius. Of spheres for which the grid does not reach far enough it finds
/// anything.
double MeshSearch::search(const Call& call, const RestFrame& frame) {
  call.context.progress.begin("features", call.spheres.size());
  const MeshToucher toucher(call.mesh, Domain::open(), call.options);
  const NearWall near_wall(grid_, frame, kernels::level_to_run(call.options.simd));
  for_each_block(call, [&](std::span<const exact::Sphere<3>> block, std::size_t first,
                           SearchScratch& scratch) {
    for (const std::uint32_t k : near_wall.find(block, scratch.near)) {
      double center[3];
      frame.bring_back(block[k].center, center);
      choose(call, frame, block[k], center, grid_.near(center), scratch.candidates);
      if (scratch.candidates.empty()) continue;
      scratch.tests += scratch.candidates.size();
      toucher({static_cast<ElementIndex>(first + k), block[k], scratch.candidates, {}},
              scratch.found);
    }
  });
  return largest_of_workers(call);
}

/// Keeps the triangles near whose plane the center lies, and whose box meets the box around the
/// sphere, as the search of boxes does.
void MeshSearch::choose(const Call& call, const RestFrame& frame, const exact::Sphere<3>& sphere,
                        const double (&center)[3], std::span<const ElementIndex> near,
                        base::Array<ContactPair>& candidates) const {
  candidates.clear();
  const exact::Box<3> around = walls::box_around(sphere, call.options.margin);
  const double reach = frame.reach_at_rest(sphere.radius + call.options.margin) + error_of_planes_;
  const FittedBoxes& boxes = call.mesh.boxes();
  for (const ElementIndex part : near) {
    const auto& [normal, offset] = planes_[part];
    const double height =
        normal[0] * center[0] + normal[1] * center[1] + normal[2] * center[2] - offset;
    if (std::fabs(height) > reach) continue;
    bool meets = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      meets = meets && boxes.lower[axis][part] <= around.upper[axis] &&
              boxes.upper[axis][part] >= around.lower[axis];
    }
    if (meets) candidates.push_back({0, part});  // whose they are is known
  }
}

/// The normal of a triangle in which products cancel too much errs too much, and is left out; so is
/// all beyond ordinary numbers. Of the others each component errs by less than 2^-30.
void MeshSearch::lay_planes(double reach) {
  base::resize_for_overwrite(planes_, triangles_.size());
  double farthest = reach;
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    const auto& [a, b, c] = triangles_[k];
    const auto& p = anchor_[a];
    double e[3], f[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      e[axis] = anchor_[b][axis] - p[axis];
      f[axis] = anchor_[c][axis] - p[axis];
      farthest = std::max(
          {farthest, std::fabs(p[axis]), std::fabs(anchor_[b][axis]), std::fabs(anchor_[c][axis])});
    }
    const double x = e[1] * f[2] - e[2] * f[1];
    const double y = e[2] * f[0] - e[0] * f[2];
    const double z = e[0] * f[1] - e[1] * f[0];
    const double length = std::sqrt(x * x + y * y + z * z);
    const double sizes = std::sqrt((e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) *
                                   (f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
    planes_[k] = {};
    const bool is_certain = length > 0x1p-16 * sizes && length < 2.0 * sizes;
    if (!(is_certain && length > 0x1p-200 && sizes < 0x1p200)) continue;
    const double inverse = 1.0 / length;
    planes_[k] = {{x * inverse, y * inverse, z * inverse}, 0.0};
    const auto& normal = planes_[k].normal;
    planes_[k].offset = normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2];
  }
  error_of_planes_ =
      farthest < 0x1p1000 ? 0x1p-26 * farthest : std::numeric_limits<double>::infinity();
}

void MeshSearch::write(const Call& call, const MeshContactArrays& arrays, Statistics& statistics) {
  statistics.algorithm = Algorithm::rows;
  statistics.reason = "the grid of a mesh";
  statistics.threads = static_cast<int>(call.workers);
  statistics.simd = kernels::level_to_run(call.options.simd);
  statistics.elements = call.spheres.size() + call.mesh.size();
  statistics.dimensions = 3;
  for (std::size_t k = 0; k < call.workers; ++k) {
    statistics.candidate_tests += scratch_[k].tests;
    statistics.exact_decisions += scratch_[k].found.exact_decisions;
    statistics.contact_pairs += scratch_[k].found.contacts.size();
  }
  require_allowed(statistics.contact_pairs, call.options);
  const std::uint64_t bytes = statistics.contact_pairs * (sizeof(MeshContact) + sizeof(ImageShift));
  memory_.take_for_pairs(bytes);
  memory_.give_back_pairs(bytes);
  arrays.contacts.clear();
  arrays.contacts.reserve(statistics.contact_pairs);
  for (std::size_t k = 0; k < call.workers; ++k) {
    for (const ImageContact<MeshContact>& one : scratch_[k].found.contacts) {
      call.context.work.did(1);
      arrays.contacts.push_back(one.contact);
    }
  }
  arrays.shifts.assign(call.options.shifts == Shifts::stored ? arrays.contacts.size() : 0, {});
}

void MeshSearch::measure(const Call& call, const MeshContactArrays& arrays,
                         Statistics& statistics) {
  const Quantities wanted = call.options.quantities;
  base::Stopwatch stopwatch;
  const lists::SizedGeometry sized(arrays.geometry, wanted, arrays.contacts.size(), memory_);
  if (wanted.empty()) return;
  call.context.progress.begin("measure", arrays.contacts.size());
  const FeatureMeasurer measurer(call.mesh, Domain::open());
  measure_contacts(arrays.contacts.size(), arrays.geometry.spans(), call.workers, call.context.work,
                   [&](std::size_t k, Quantities quantities) {
                     const MeshContact& contact = arrays.contacts[k];
                     return measurer(elements::sphere_at<3>(call.spheres, contact.sphere), contact,
                                     {}, quantities);
                   });
  statistics.measure_seconds = stopwatch.lap();
}

}  // namespace abut::walls
