#include "walls/mesh_search.hpp"

#include "base/asking_workers.hpp"
#include "base/callers_exception.hpp"
#include "base/lack_of_memory.hpp"
#include "base/stopwatch.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/reject_element.hpp"
#include "elements/valid_element.hpp"
#include "kernels/simd_level.hpp"
#include "lists/result_buffer.hpp"
#include "walls/feature_measurer.hpp"
#include "walls/grid/near_wall.hpp"
#include "walls/measure_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace abut::walls {
namespace {

constexpr std::uint64_t steps_of_candidate = 64;

/// Candidates that are worth a call of the vector kernels: of large spheres beside small triangles,
/// those of few spheres, so that memory follows one sphere and not a block of them.
constexpr std::size_t enough_candidates = 1024;

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
  planes_.build(anchor_, triangles_, grid_, wide, call.context.work);
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
  for_each_block(call, [](const kernels::ElementColumns& block, std::size_t, std::size_t count,
                          SearchScratch& scratch) {
    std::size_t k = 0;
    for (; k < count; ++k) {
      const exact::Sphere<3> sphere = elements::sphere_at<3>(block, k);
      if (!elements::is_valid(sphere)) break;
      scratch.largest_radius = std::max(scratch.largest_radius, sphere.radius);
    }
    return k;
  });
  return largest_of_workers(call);
}

double MeshSearch::largest_of_workers(const Call& call) const noexcept {
  double largest = 0.0;
  for (std::size_t k = 0; k < call.workers; ++k) {
    largest = std::max(largest, scratch_[k].largest_radius);
  }
  return largest;
}

/// Calls act(block, number of its first sphere, how many there are, scratch) for each block of a
/// worker's share. It returns how many spheres it looked at, up to the first one that is not valid.
template <class Act>
void MeshSearch::for_each_block(const Call& call, Act&& act) {
  const elements::SphereReader reader(call.spheres);
  for (SearchScratch& scratch : scratch_) scratch.start_anew();
  base::for_each_share(
      call.workers, call.context.work, [&](std::size_t worker, base::WorkCounter& work) {
        const auto [first, last] = base::share_of(worker, call.workers, call.spheres.size());
        SearchScratch& scratch = scratch_[worker];
        for (std::size_t begin = first; begin < last; begin += block_size) {
          const std::size_t count = std::min(block_size, last - begin);
          const kernels::ElementColumns block = reader.read(begin, count, scratch.room);
          const std::uint64_t tests = scratch.tests;
          const std::size_t valid = act(block, begin, count, scratch);
          if (valid < count) {
            elements::reject_element(begin + valid, elements::sphere_at<3>(block, valid));
          }
          call.context.progress.advance(count);
          work.did(2 * count + steps_of_candidate * (scratch.tests - tests));
        }
      });
}

/// Returns the largest radius. Of spheres for which the grid does not reach far enough it finds
/// anything.
double MeshSearch::search(const Call& call, const RestFrame& frame) {
  call.context.progress.begin("features", call.spheres.size());
  const Simd simd = kernels::level_to_run(call.options.simd);
  const MeshToucher toucher(call.mesh, Domain::open(), call.options);
  const TriangleBlock triangles(call.mesh, call.options.margin, simd);
  const NearWall near_wall(grid_, frame, simd);
  for_each_block(call, [&](const kernels::ElementColumns& block, std::size_t first,
                           std::size_t count, SearchScratch& scratch) {
    const NearSpheres near = near_wall.find(block, count, scratch.near);
    scratch.largest_radius = std::max(scratch.largest_radius, near.largest_radius);
    const auto decide = [&] {
      scratch.tests += scratch.candidates.size();
      base::resize_for_overwrite(scratch.parts, scratch.candidates.size());
      const BlockCandidates candidates{block, scratch.candidates};
      triangles.decide(candidates, scratch.parts, scratch.found.exact_decisions);
      toucher.touch(first, candidates, scratch.parts, scratch.found);
      scratch.candidates.clear();
    };
    scratch.candidates.clear();
    for (const std::uint32_t one :
         near_wall.sift(block, scratch.near, near.numbers.size(), {planes_, call.options.margin},
                        scratch.columns, scratch.kept)) {
      choose(call, block, one, scratch);
      if (scratch.candidates.size() >= enough_candidates) decide();
    }
    decide();
    return near.valid;
  });
  return largest_of_workers(call);
}

/// Appends the triangles near whose plane the center lies, and whose box meets the box around the
/// sphere, as the search of boxes does.
void MeshSearch::choose(const Call& call, const kernels::ElementColumns& block, std::size_t near,
                        SearchScratch& scratch) const {
  const kernels::NearColumns& columns = scratch.columns;
  const double center[3] = {columns.center[0][near], columns.center[1][near],
                            columns.center[2][near]};
  const std::uint32_t number = scratch.near[near];
  const exact::Box<3> around =
      walls::box_around(elements::sphere_at<3>(block, number), call.options.margin);
  const FittedBoxes& boxes = call.mesh.boxes();
  for (const ElementIndex part : grid_.parts(columns.place[near])) {
    if (planes_.is_far_from_triangle(center, part, columns.reach[near])) continue;
    bool meets = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      meets = meets && boxes.lower[axis][part] <= around.upper[axis] &&
              boxes.upper[axis][part] >= around.lower[axis];
    }
    if (meets) scratch.candidates.push_back({number, part});
  }
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
  base::reserve_to_grow(arrays.contacts, statistics.contact_pairs);
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
  const FeatureContacts contacts{measurer, arrays.contacts, {}, call.workers, statistics.simd};
  measure_contacts(contacts, arrays.geometry.spans(), call.context.work, [&](ElementIndex number) {
    return elements::sphere_at<3>(call.spheres, number);
  });
  statistics.measure_seconds = stopwatch.lap();
}

}  // namespace abut::walls
