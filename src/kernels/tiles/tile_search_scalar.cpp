// The candidate loop in plain C++: the level `scalar`, and the only one without Highway. The same
// sequence of operations in single precision as in tile_search_simd.cpp.

#include "kernels/scalar_probe.hpp"
#include "kernels/tiles/tile_search.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace abut::kernels {
namespace {

/// Tests an element against runs of candidates.
template <int Dim, ElementShape Shape>
class ScalarPairTester {
 public:
  ScalarPairTester(const TileView& tile, SearchJob& job) : tile_(tile), job_(job) {}

  template <class RunsOf>
  void test_all(std::uint32_t first, std::uint32_t last, RunsOf runs_of) {
    for (std::uint32_t p = first; p < last; ++p) {
      const Element element(tile_, job_, p);
      const auto runs = runs_of(p);
      for (std::size_t k = 0; k < runs.size(); ++k) test(element, runs[k]);
      take_now_and_then();
    }
  }

  /// Elements [first, last) of a row, each with those of the cells that it lies near: run by run,
  /// of a batch of elements at a time.
  template <std::size_t Runs>
  void test_nearby(std::uint32_t first, std::uint32_t last, const RowOfCells<Runs>& row) {
    constexpr std::uint32_t batch_size = 64;
    for (; first < last; first += batch_size) {
      for (std::size_t k = 0; k < Runs; ++k) {
        for (std::uint32_t p = first; p < std::min(last, first + batch_size); ++p) {
          test_if_near(p, k, row);
        }
      }
    }
  }

  /// The first `own` elements of the runs, each with all that follow it.
  void test_block(std::uint32_t own, std::span<const Run> runs) {
    const std::uint32_t begin = runs[0].begin;
    for (std::uint32_t p = begin; p < begin + own; ++p) {
      const Element element(tile_, job_, p);
      test(element, {p + 1, runs[0].end});
      for (const Run& run : runs.subspan(1)) test(element, run);
      take_now_and_then();
    }
  }

  void test(const CoarseElement& coarse, std::span<const Run> runs) {
    const Element element(tile_, job_, coarse);
    for (const Run& run : runs) test(element, run);
  }

  void finish() {}

  void take_now_and_then() {
    if (job_.candidate_tests - tests_at_take_ < tests_between_takes) return;
    tests_at_take_ = job_.candidate_tests;
    job_.take(job_);
  }

 private:
  using Element = ScalarProbe<Dim, Shape>;

  void test(const Element& element, const Run& run) {
    job_.candidate_tests += run.end - run.begin;
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      const ProbeAnswer hit = element.test(q);
      if (hit == ProbeAnswer::none) continue;
      push_hit(job_, element.number(), tile_.number[q], hit);
    }
  }

  /// Faces of an element's cell within its reach, on an axis. Those of a flat tile, where numbers
  /// are infinite or none, are.
  struct Sides {
    bool below;
    bool above;
  };

  [[nodiscard]] Sides sides(std::uint32_t p, int axis, float index) const {
    const float radius =
        Shape == ElementShape::equal_spheres ? tile_.common_radius : tile_.size[0][p];
    const float reach = tile_.common_radius + job_.margin + job_.slack + radius;
    const float within = tile_.center[axis][p] * tile_.per_unit[axis] + 1.0f - index;
    const float near = reach * tile_.per_unit[axis] + nearby_slack;
    return {!(within > near), !(within < 1.0f - near)};
  }

  /// The runs are those of TileSearch: this row and the next; the last three are of the next layer.
  template <std::size_t Runs>
  void test_if_near(std::uint32_t p, std::size_t k, const RowOfCells<Runs>& row) {
    if (k > 0) {
      const Sides y = sides(p, 1, row.index[1]);
      if ((k == 1 || k == 4) && !y.above) return;
      if (k == 2 && !y.below) return;
      if (k > 1 && !sides(p, Dim - 1, row.index[Dim - 1]).above) return;
    }
    const Sides x = sides(p, 0, static_cast<float>(tile_.cell[p] - row.first_cell));
    const std::uint32_t* const cell = tile_.cell_begin + tile_.cell[p] + row.step[k];
    test(Element(tile_, job_, p), {k == 0 ? p + 1 : cell[x.below ? -1 : 0], cell[x.above ? 2 : 1]});
  }

  const TileView& tile_;
  SearchJob& job_;
  std::uint64_t tests_at_take_ = job_.candidate_tests;
};

#include "kernels/tiles/tile_search-inl.hpp"

#include "kernels/element_variants-inl.hpp"

#include "kernels/tiles/tile_search_variants-inl.hpp"

void search_tile(const TileView& tile, const Layers& layers, SearchJob& job, int dimensions) {
  search_with<ScalarPairTester>(tile, layers, job, dimensions);
}

void test_coarse_in_tile(const TileView& tile, SearchJob& job, int dimensions,
                         const CoarseElement& coarse, std::span<const Run> runs) {
  test_coarse_with<ScalarPairTester>(tile, job, dimensions, coarse, runs);
}

void pair_up(const std::uint32_t* element, const std::uint32_t* partner, std::size_t count,
             ContactPair* pairs) {
  for (std::size_t k = 0; k < count; ++k) {
    pairs[k] = {std::min(element[k], partner[k]), std::max(element[k], partner[k])};
  }
}

}  // namespace

TileKernels scalar_tile_kernels() {
  return {search_tile, test_coarse_in_tile, pair_up};
}

}  // namespace abut::kernels
