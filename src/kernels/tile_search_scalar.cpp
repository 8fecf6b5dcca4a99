// The candidate loop in plain C++: the level `scalar`, and the only one without Highway. The same
// sequence of operations in single precision as in tile_search_simd.cpp.

#include "kernels/tile_search.hpp"

#include <algorithm>

namespace abut::kernels {
namespace {

/// Candidates gathered contiguously.
template <int Dim, bool EqualRadii>
class ScalarBlock {
 public:
  struct Element {
    float center[Dim];
    float reach;  ///< radius + margin, + the common radius where all are equal
    float slack;
    std::uint32_t number;
  };

  ScalarBlock(const TileView& tile, SearchJob& job) : tile_(tile), job_(job) {}

  [[nodiscard]] std::size_t size() const { return size_; }

  void append(std::size_t begin, std::size_t end) {
    for (int axis = 0; axis < Dim; ++axis) {
      std::copy(tile_.center[axis] + begin, tile_.center[axis] + end, job_.block[axis] + size_);
    }
    if constexpr (!EqualRadii) {
      std::copy(tile_.radius + begin, tile_.radius + end, job_.block[3] + size_);
    }
    std::copy(tile_.number + begin, tile_.number + end, job_.block_number + size_);
    size_ += end - begin;
  }

  void close() {}
  void finish() {}

  [[nodiscard]] Element element(std::size_t p) const {
    Element result;
    for (int axis = 0; axis < Dim; ++axis) result.center[axis] = job_.block[axis][p];
    result.reach = reach_of(EqualRadii ? tile_.common_radius : job_.block[3][p]);
    result.slack = job_.slack;
    result.number = job_.block_number[p];
    return result;
  }

  [[nodiscard]] Element element_of(const Visitor& visitor) const {
    Element result;
    std::copy_n(visitor.center, Dim, result.center);
    result.reach = reach_of(visitor.radius);
    result.slack = visitor.slack;
    result.number = visitor.number;
    return result;
  }

  /// Tests the element against all candidates from `first` on.
  void meet(const Element& element, std::size_t first) {
    if (first >= size_) return;
    job_.candidate_tests += size_ - first;
    const float outer = element.reach + element.slack;
    const float inner = element.reach - element.slack;
    for (std::size_t q = first; q < size_; ++q) {
      float difference = element.center[0] - job_.block[0][q];
      float distance_squared = difference * difference;
      for (int axis = 1; axis < Dim; ++axis) {
        difference = element.center[axis] - job_.block[axis][q];
        distance_squared += difference * difference;
      }
      const float radius = EqualRadii ? 0.0f : job_.block[3][q];
      const float farthest = outer + radius;
      if (!(distance_squared <= farthest * farthest)) continue;
      const float nearest = std::max(inner + radius, 0.0f);
      const std::uint32_t partner = job_.block_number[q];
      if (!(distance_squared < nearest * nearest) && !job_.decide(job_, element.number, partner)) {
        continue;
      }
      job_.pairs[job_.filled++] = {std::min(element.number, partner),
                                   std::max(element.number, partner)};
      if (job_.filled + 2 * widest_vector > job_.capacity) job_.flush(job_);
    }
  }

 private:
  [[nodiscard]] float reach_of(float radius) const {
    return radius + job_.margin + (EqualRadii ? tile_.common_radius : 0.0f);
  }

  const TileView& tile_;
  SearchJob& job_;
  std::size_t size_ = 0;
};

#include "kernels/tile_search-inl.hpp"

#include "kernels/tile_search_variants-inl.hpp"

void search_tile(const TileView& tile, SearchJob& job, int dimensions) {
  search_with<ScalarBlock>(tile, job, dimensions);
}

void visit_tile(const TileView& tile, SearchJob& job, int dimensions, const Visitor& visitor,
                std::span<const Run> runs) {
  visit_with<ScalarBlock>(tile, job, dimensions, visitor, runs);
}

}  // namespace

TileKernels scalar_tile_kernels() {
  return {search_tile, visit_tile};
}

}  // namespace abut::kernels
