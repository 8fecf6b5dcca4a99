// The candidate loop in plain C++: the level `scalar`, and the only one without Highway. The same
// sequence of operations in single precision as in tile_search_simd.cpp.

#include "kernels/tile_search.hpp"

#include <algorithm>
#include <array>

namespace abut::kernels {
namespace {

/// Tests an element against runs of candidates.
template <int Dim, bool EqualRadii>
class ScalarMeeting {
 public:
  ScalarMeeting(const TileView& tile, SearchJob& job) : tile_(tile), job_(job) {}

  template <class RunsOf>
  void meet_all(std::uint32_t first, std::uint32_t last, RunsOf runs_of) {
    for (std::uint32_t p = first; p < last; ++p) {
      const Element element = element_at(p);
      const auto runs = runs_of(p);
      for (std::size_t k = 0; k < runs.size(); ++k) meet(element, runs[k]);
    }
  }

  /// The first `own` elements of the runs, each with all that follow it.
  void meet_block(std::uint32_t own, std::span<const Run> runs) {
    const std::uint32_t begin = runs[0].begin;
    for (std::uint32_t p = begin; p < begin + own; ++p) {
      const Element element = element_at(p);
      meet(element, {p + 1, runs[0].end});
      for (const Run& run : runs.subspan(1)) meet(element, run);
    }
  }

  void meet(const Visitor& visitor, std::span<const Run> runs) {
    Element element;
    std::copy_n(visitor.center, Dim, element.center);
    element.reach = reach_of(visitor.radius);
    element.slack = visitor.slack;
    element.number = visitor.number;
    for (const Run& run : runs) meet(element, run);
  }

  void finish() {}

 private:
  struct Element {
    float center[Dim];
    float reach;  ///< radius + margin, + the common radius where all are equal
    float slack;
    std::uint32_t number;
  };

  [[nodiscard]] Element element_at(std::uint32_t p) const {
    Element element;
    for (int axis = 0; axis < Dim; ++axis) element.center[axis] = tile_.center[axis][p];
    element.reach = reach_of(EqualRadii ? tile_.common_radius : tile_.radius[p]);
    element.slack = job_.slack;
    element.number = tile_.number[p];
    return element;
  }

  void meet(const Element& element, const Run& run) {
    job_.candidate_tests += run.end - run.begin;
    const float outer = element.reach + element.slack;
    const float inner = element.reach - element.slack;
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      float difference = element.center[0] - tile_.center[0][q];
      float distance_squared = difference * difference;
      for (int axis = 1; axis < Dim; ++axis) {
        difference = element.center[axis] - tile_.center[axis][q];
        distance_squared += difference * difference;
      }
      const float radius = EqualRadii ? 0.0f : tile_.radius[q];
      const float farthest = outer + radius;
      if (!(distance_squared <= farthest * farthest)) continue;
      const float nearest = std::max(inner + radius, 0.0f);
      push(element.number, tile_.number[q], distance_squared < nearest * nearest);
    }
  }

  void push(std::uint32_t element, std::uint32_t partner, bool sure) {
    Findings& to = *job_.findings;
    if (to.found == Findings::room) job_.take(job_);
    if (!sure) to.doubtful[to.doubts++] = static_cast<std::uint32_t>(to.found);
    to.element[to.found] = element;
    to.partner[to.found++] = partner;
  }

  [[nodiscard]] float reach_of(float radius) const {
    return radius + job_.margin + (EqualRadii ? tile_.common_radius : 0.0f);
  }

  const TileView& tile_;
  SearchJob& job_;
};

#include "kernels/tile_search-inl.hpp"

#include "kernels/tile_search_variants-inl.hpp"

void search_tile(const TileView& tile, SearchJob& job, int dimensions) {
  search_with<ScalarMeeting>(tile, job, dimensions);
}

void visit_tile(const TileView& tile, SearchJob& job, int dimensions, const Visitor& visitor,
                std::span<const Run> runs) {
  visit_with<ScalarMeeting>(tile, job, dimensions, visitor, runs);
}

void pair_up(const std::uint32_t* element, const std::uint32_t* partner, std::size_t count,
             ContactPair* pairs) {
  for (std::size_t k = 0; k < count; ++k) {
    pairs[k] = {std::min(element[k], partner[k]), std::max(element[k], partner[k])};
  }
}

}  // namespace

TileKernels scalar_tile_kernels() {
  return {search_tile, visit_tile, pair_up};
}

}  // namespace abut::kernels
