// The candidate loop in plain C++: the level `scalar`, and the only one without Highway. The same
// sequence of operations in single precision as in tile_search_simd.cpp.

#include "kernels/tile_search.hpp"

#include <algorithm>
#include <type_traits>

namespace abut::kernels {
namespace {

enum class Finding { none, doubtful, sure };

/// An element beside its candidates: equal spheres, or spheres.
template <int Dim, TileShape Shape>
class Probe {
 public:
  Probe(const TileView& tile, const SearchJob& job, std::uint32_t p)
      : tile_(tile), number_(tile.number[p]) {
    for (int axis = 0; axis < Dim; ++axis) center_[axis] = tile.center[axis][p];
    set_reach(job, equal ? tile.common_radius : tile.size[0][p], job.slack);
  }

  Probe(const TileView& tile, const SearchJob& job, const Visitor& visitor)
      : tile_(tile), number_(visitor.number) {
    std::copy_n(visitor.center, Dim, center_);
    set_reach(job, visitor.size[0], visitor.slack);
  }

  [[nodiscard]] std::uint32_t number() const { return number_; }

  [[nodiscard]] Finding meet(std::uint32_t q) const {
    float difference = center_[0] - tile_.center[0][q];
    float distance_squared = difference * difference;
    for (int axis = 1; axis < Dim; ++axis) {
      difference = center_[axis] - tile_.center[axis][q];
      distance_squared += difference * difference;
    }
    const float radius = equal ? 0.0f : tile_.size[0][q];
    const float farthest = outer_ + radius;
    if (!(distance_squared <= farthest * farthest)) return Finding::none;
    const float nearest = std::max(inner_ + radius, 0.0f);
    return distance_squared < nearest * nearest ? Finding::sure : Finding::doubtful;
  }

 private:
  static constexpr bool equal = Shape == TileShape::equal_spheres;

  void set_reach(const SearchJob& job, float radius, float slack) {
    const float reach = radius + job.margin + (equal ? tile_.common_radius : 0.0f);
    outer_ = reach + slack;
    inner_ = reach - slack;
  }

  const TileView& tile_;
  float center_[Dim];
  float outer_;
  float inner_;
  std::uint32_t number_;
};

/// The same among boxes: on each axis neither may lie behind the other's end.
template <int Dim>
class Probe<Dim, TileShape::boxes> {
 public:
  Probe(const TileView& tile, const SearchJob& job, std::uint32_t p)
      : tile_(tile),
        outer_(job.margin + job.slack),
        inner_(job.margin - job.slack),
        number_(tile.number[p]) {
    for (int axis = 0; axis < Dim; ++axis) {
      lower_[axis] = tile.center[axis][p];
      width_[axis] = tile.size[axis][p];
    }
  }

  Probe(const TileView& tile, const SearchJob& job, const Visitor& visitor)
      : tile_(tile),
        outer_(job.margin + visitor.slack),
        inner_(job.margin - visitor.slack),
        number_(visitor.number) {
    std::copy_n(visitor.center, Dim, lower_);
    std::copy_n(visitor.size, Dim, width_);
  }

  [[nodiscard]] std::uint32_t number() const { return number_; }

  [[nodiscard]] Finding meet(std::uint32_t q) const {
    bool sure = true;
    for (int axis = 0; axis < Dim; ++axis) {
      const float behind = lower_[axis] - tile_.center[axis][q];
      const float width = tile_.size[axis][q];
      if (!(behind <= width + outer_ && -behind <= width_[axis] + outer_)) return Finding::none;
      sure = sure && behind < width + inner_ && -behind < width_[axis] + inner_;
    }
    return sure ? Finding::sure : Finding::doubtful;
  }

 private:
  const TileView& tile_;
  float lower_[Dim];
  float width_[Dim];
  float outer_;
  float inner_;
  std::uint32_t number_;
};

/// Tests an element against runs of candidates.
template <int Dim, TileShape Shape>
class ScalarMeeting {
 public:
  ScalarMeeting(const TileView& tile, SearchJob& job) : tile_(tile), job_(job) {}

  template <class RunsOf>
  void meet_all(std::uint32_t first, std::uint32_t last, RunsOf runs_of) {
    for (std::uint32_t p = first; p < last; ++p) {
      const Element element(tile_, job_, p);
      const auto runs = runs_of(p);
      for (std::size_t k = 0; k < runs.size(); ++k) meet(element, runs[k]);
    }
  }

  /// The first `own` elements of the runs, each with all that follow it.
  void meet_block(std::uint32_t own, std::span<const Run> runs) {
    const std::uint32_t begin = runs[0].begin;
    for (std::uint32_t p = begin; p < begin + own; ++p) {
      const Element element(tile_, job_, p);
      meet(element, {p + 1, runs[0].end});
      for (const Run& run : runs.subspan(1)) meet(element, run);
    }
  }

  void meet(const Visitor& visitor, std::span<const Run> runs) {
    const Element element(tile_, job_, visitor);
    for (const Run& run : runs) meet(element, run);
  }

  void finish() {}

 private:
  using Element = Probe<Dim, Shape>;

  void meet(const Element& element, const Run& run) {
    job_.candidate_tests += run.end - run.begin;
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      const Finding finding = element.meet(q);
      if (finding == Finding::none) continue;
      push(element.number(), tile_.number[q], finding);
    }
  }

  void push(std::uint32_t element, std::uint32_t partner, Finding finding) {
    Findings& to = *job_.findings;
    if (to.found == Findings::room) job_.take(job_);
    if (finding == Finding::doubtful) {
      to.doubtful[to.doubts++] = static_cast<std::uint32_t>(to.found);
    }
    to.element[to.found] = element;
    to.partner[to.found++] = partner;
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
