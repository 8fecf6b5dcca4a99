// Layers in plain C++: the level `scalar`, and the only one without Highway. The same operations on
// the same numbers as in layer_search_simd.cpp.

#include "kernels/layers/layer_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::kernels {
namespace {

#include "kernels/layers/runs_of_row-inl.hpp"

template <int Dim>
class ScalarLayerTester {
 public:
  ScalarLayerTester(const LayerPair& layers, SearchJob& job) : layers_(layers), job_(job) {}

  void search() {
    for (std::uint32_t row = 1; row <= layers_.rows; ++row) {
      const RunsOfRow<Dim> ahead(layers_, row);
      const Run elements = ahead.elements();
      for (std::uint32_t p = elements.begin; p < elements.end; ++p) {
        for (std::size_t k = 0; k < RunsOfRow<Dim>::size; ++k) {
          test(p, ahead.run(k, p, layers_.column[p]));
        }
        take_now_and_then();
      }
    }
  }

 private:
  void test(std::uint32_t p, const Run& run) {
    job_.candidate_tests += run.end - run.begin;
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      float distance_squared = 0.0f;
      for (int axis = 0; axis < Dim; ++axis) {
        const auto difference =
            static_cast<float>(layers_.position[axis][q] - layers_.position[axis][p]);
        distance_squared += difference * difference;
      }
      const ReachSquares reach = squares_of(p, q);
      if (distance_squared <= reach.outer) push(p, q, distance_squared < reach.inner);
    }
  }

  /// Squares of the reach less and plus the slack.
  struct ReachSquares {
    float inner;
    float outer;
  };

  [[nodiscard]] ReachSquares squares_of(std::uint32_t p, std::uint32_t q) const {
    if (layers_.radius == nullptr) return {layers_.inner, layers_.outer};
    const float other = layers_.radius[q];
    const float nearest = std::max((layers_.radius[p] + layers_.nearest_margin) + other, 0.0f);
    const float farthest = (layers_.radius[p] + layers_.farthest_margin) + other;
    return {nearest * nearest, farthest * farthest};
  }

  void push(std::uint32_t p, std::uint32_t q, bool is_sure) {
    HitBuffer& to = *job_.hits;
    if (to.found == HitBuffer::size) job_.take(job_);
    if (!is_sure) to.undecided[to.undecided_count++] = static_cast<std::uint32_t>(to.found);
    to.element[to.found] = layers_.number[p];
    to.partner[to.found++] = layers_.number[q];
  }

  void take_now_and_then() {
    if (job_.candidate_tests - tests_at_take_ < tests_between_takes) return;
    tests_at_take_ = job_.candidate_tests;
    job_.take(job_);
  }

  const LayerPair& layers_;
  SearchJob& job_;
  std::uint64_t tests_at_take_ = job_.candidate_tests;
};

std::size_t scatter(const double*, std::size_t, int, const PositionMap&, std::uint32_t,
                    const RecordsByLayer&) {
  return 0;
}

void split(const PositionRecord* records, std::size_t count, const LayerColumns& columns) {
  for (std::size_t k = 0; k < count; ++k) {
    for (int axis = 0; axis < 3; ++axis) columns.position[axis][k] = records[k].position[axis];
    columns.number[k] = records[k].number;
    columns.column[k] =
        static_cast<std::uint32_t>(records[k].position[columns.row_axis]) >> columns.column_shift;
  }
}

void search(const LayerPair& layers, SearchJob& job, int dimensions) {
  if (dimensions == 2) {
    ScalarLayerTester<2>(layers, job).search();
  } else {
    ScalarLayerTester<3>(layers, job).search();
  }
}

}  // namespace

LayerKernels scalar_layer_kernels() {
  return {scatter, split, search};
}

}  // namespace abut::kernels
