// Layers in plain C++: the level `scalar`, and the only one without Highway. The same operations on
// the same numbers as in layer_search_simd.cpp.

#include "kernels/layers/layer_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace abut::kernels {
namespace {

#include "kernels/layers/runs_of_row-inl.hpp"

#include "kernels/layers/near_runs-inl.hpp"

#include "kernels/layers/far_runs-inl.hpp"

#include "kernels/layers/coarse_runs-inl.hpp"

/// A reach less and plus the slack; of spheres the squares.
struct ReachBounds {
  float inner;
  float outer;
};

/// The elements of some layers, tested one by one.
class ScalarTester {
 protected:
  ScalarTester(const LayerPair& layers, SearchJob& job) : layers_(layers), job_(job) {}

  /// From a place in the box of all to the element at place q.
  [[nodiscard]] float difference(const std::int32_t (&from)[3], std::uint32_t q, int axis) const {
    return static_cast<float>(layers_.position[axis][q] - from[axis]);
  }

  template <int Dim>
  [[nodiscard]] float distance_squared(const std::int32_t (&from)[3], std::uint32_t q) const {
    return sum_of_squares<Dim>([&](int axis) { return difference(from, q, axis); });
  }

  template <int Dim>
  [[nodiscard]] float gap(const std::int32_t (&from)[3], const float (&width)[3],
                          std::uint32_t q) const {
    return gap<Dim>([&](int axis) { return difference(from, q, axis); }, width, q);
  }

  template <int Dim, class Differences>
  [[nodiscard]] static float sum_of_squares(const Differences& difference_on) {
    float sum = 0.0f;
    for (int axis = 0; axis < Dim; ++axis) {
      const float difference = difference_on(axis);
      sum += difference * difference;
    }
    return sum;
  }

  /// The largest gap of two boxes over the axes; a zero is +0.
  template <int Dim, class Differences>
  [[nodiscard]] float gap(const Differences& difference_on, const float (&width)[3],
                          std::uint32_t q) const {
    float largest = -std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < Dim; ++axis) {
      const float difference = difference_on(axis);
      largest = std::max(
          {largest, difference - width[axis], (0.0f - difference) - layers_.width[axis][q]});
    }
    return largest;
  }

  void test(std::uint32_t element, std::uint32_t q, float distance, const ReachBounds& reach) {
    if (distance > reach.outer) return;
    add(element, q);
    if (distance < reach.inner) return;
    HitBuffer& to = *job_.hits;
    to.undecided[to.undecided_count++] = static_cast<std::uint32_t>(to.found - 1);
  }

  void add(std::uint32_t element, std::uint32_t q) {
    HitBuffer& to = *job_.hits;
    if (to.found == HitBuffer::size) job_.take(job_);
    to.element[to.found] = element;
    to.partner[to.found++] = layers_.number[q];
  }

  [[nodiscard]] static ReachBounds squares_of(float nearest_radius, float farthest_radius,
                                              float other) {
    const float nearest = std::max(nearest_radius + other, 0.0f);
    const float farthest = farthest_radius + other;
    return {nearest * nearest, farthest * farthest};
  }

  void count(const Run& run) { job_.candidate_tests += run.end - run.begin; }

  void take_now_and_then() {
    if (job_.candidate_tests - tests_at_take_ < tests_between_takes) return;
    tests_at_take_ = job_.candidate_tests;
    job_.take(job_);
  }

 private:
  const LayerPair& layers_;
  SearchJob& job_;
  std::uint64_t tests_at_take_ = job_.candidate_tests;
};

template <int Dim>
class ScalarLayerTester : ScalarTester {
 public:
  ScalarLayerTester(const LayerPair& layers, SearchJob& job)
      : ScalarTester(layers, job), layers_(layers) {}

  void search() {
    for (std::uint32_t row = 1; row <= layers_.rows; ++row) {
      const RunsOfRow<Dim> ahead(layers_, row);
      const Run elements = ahead.elements();
      for (std::uint32_t p = elements.begin; p < elements.end; ++p) {
        for (std::size_t k = 0; k < RunsOfRow<Dim>::size; ++k) {
          test_run(p, ahead.run(k, p, layers_.column[p]));
        }
        take_now_and_then();
      }
    }
  }

 private:
  void test_run(std::uint32_t p, const Run& run) {
    count(run);
    const std::int32_t from[3] = {layers_.position[0][p], layers_.position[1][p],
                                  layers_.position[2][p]};
    if (layers_.largest_square >= 0) return test_exactly(p, from, run);
    if (layers_.shape == ElementShape::boxes) return test_boxes(p, from, run);
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      test(layers_.number[p], q, distance_squared<Dim>(from, q), squares(p, q));
    }
  }

  void test_exactly(std::uint32_t p, const std::int32_t (&from)[3], const Run& run) {
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      std::int32_t square = 0;
      for (int axis = 0; axis < Dim; ++axis) {
        const std::int32_t difference = layers_.position[axis][q] - from[axis];
        square += difference * difference;
      }
      if (square <= layers_.largest_square) add(layers_.number[p], q);
    }
  }

  void test_boxes(std::uint32_t p, const std::int32_t (&from)[3], const Run& run) {
    float width[3]{};
    for (int axis = 0; axis < Dim; ++axis) width[axis] = layers_.width[axis][p];
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      test(layers_.number[p], q, gap<Dim>(from, width, q), {layers_.inner, layers_.outer});
    }
  }

  [[nodiscard]] ReachBounds squares(std::uint32_t p, std::uint32_t q) const {
    if (layers_.radius == nullptr) return {layers_.inner, layers_.outer};
    return squares_of(layers_.radius[p] + layers_.nearest_margin,
                      layers_.radius[p] + layers_.farthest_margin, layers_.radius[q]);
  }

  const LayerPair& layers_;
};

/// Elements that look for smaller ones, near and far.
template <int Dim>
class ScalarSmallerTester : ScalarTester {
 public:
  ScalarSmallerTester(const ThreeLayers& layers, SearchJob& job)
      : ScalarTester(layers, job), layers_(layers) {}

  void search_near() {
    for_each_element([&](const FarSphere& element, std::uint32_t p, float reach) {
      if (reach < near_reach) search_near(element, {layers_, p, static_cast<std::int32_t>(reach)});
    });
    for_each_element([&](const FarSphere& element, std::uint32_t, float reach) {
      if (reach < near_reach || !(reach < middle_reach)) return;
      for_each_run_around<Dim>(layers_, element, [&](const Run& run) { test_far(element, run); });
      take_now_and_then();
    });
  }

  void search_far(const FarSphere& far) {
    for_each_run<Dim>(layers_, far, [&](const Run& run) { test_far(far, run); });
    take_now_and_then();
  }

 private:
  /// Calls visit(element, place, own reach) for each element of the own layer.
  template <class Visit>
  void for_each_element(const Visit& visit) const {
    for (std::uint32_t row = 1; row <= layers_.rows; ++row) {
      const Run elements = ElementsOfRow(layers_, row).elements();
      for (std::uint32_t p = elements.begin; p < elements.end; ++p) {
        visit(element_at(layers_, p), p, own_reach(layers_.radius[p], layers_.margin));
      }
    }
  }

  void search_near(const FarSphere& element, const NearRuns<Dim>& runs) {
    for (std::size_t k = 0; k < NearRuns<Dim>::size; ++k) {
      const std::uint32_t* const first = layers_.own + runs.first[k];
      test_run(element, {first[0], first[runs.columns[k]]}, near_bounds(element));
    }
    take_now_and_then();
  }

  void test_far(const FarSphere& element, const Run& run) {
    test_run(element, run, {element.nearest, element.farthest});
  }

  /// With the slack of near elements.
  [[nodiscard]] ReachBounds near_bounds(const FarSphere& element) const {
    const float radius = layers_.shape == ElementShape::boxes ? 0.0f : element.radius;
    return {radius + layers_.nearest_margin, radius + layers_.farthest_margin};
  }

  /// The bounds are those of a box, or of a sphere without the radius of its partner.
  void test_run(const FarSphere& from, const Run& run, const ReachBounds& bounds) {
    count(run);
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      const float other = layers_.radius[q];
      if (other > from.radius || (other == from.radius && layers_.number[q] >= from.number)) {
        continue;
      }
      if (layers_.shape == ElementShape::boxes) {
        test(from.number, q, gap<Dim>(from.position, from.width, q), bounds);
      } else {
        test(from.number, q, distance_squared<Dim>(from.position, q),
             squares_of(bounds.inner, bounds.outer, other));
      }
    }
  }

  const ThreeLayers& layers_;
};

/// Coarse elements and all of a layer.
template <int Dim>
class ScalarCoarseTester : ScalarTester {
 public:
  ScalarCoarseTester(const ThreeLayers& layers, SearchJob& job)
      : ScalarTester(layers, job), layers_(layers) {}

  void search(const FarSphere& coarse) {
    for_each_run_of_coarse<Dim>(layers_, coarse, [&](const Run& run) {
      count(run);
      for (std::uint32_t q = run.begin; q < run.end; ++q) test_one(coarse, q);
    });
    take_now_and_then();
  }

 private:
  void test_one(const FarSphere& coarse, std::uint32_t q) {
    const auto difference_on = [&](int axis) {
      return difference(coarse.position, q, axis) - coarse.beyond[axis];
    };
    const ReachBounds bounds{coarse.nearest, coarse.farthest};
    switch (layers_.shape) {
      case ElementShape::equal_spheres:
        return test(coarse.number, q, sum_of_squares<Dim>(difference_on), bounds);
      case ElementShape::spheres:
        return test(coarse.number, q, sum_of_squares<Dim>(difference_on),
                    squares_of(bounds.inner, bounds.outer, layers_.radius[q]));
      case ElementShape::boxes:
        return test(coarse.number, q, gap<Dim>(difference_on, coarse.width, q), bounds);
    }
  }

  const ThreeLayers& layers_;
};

std::size_t scatter(const kernels::StridedSpheres&, std::size_t, std::size_t, int,
                    const PositionMap&, const RecordsByLayer&) {
  return 0;
}

std::size_t count_in_steps(const kernels::StridedSpheres&, std::size_t, std::size_t, int, double) {
  return 0;
}

void count_entries(const PositionRecord* records, std::size_t count, const EntryMap& map,
                   std::uint32_t* entry_of, std::uint32_t* table) {
  for (std::size_t k = 0; k < count; ++k) ++table[entry_of[k] = map.entry(records[k])];
}

std::uint32_t turn_into_places(std::uint32_t* counts, std::size_t size, std::uint32_t place) {
  for (std::size_t k = 0; k < size; ++k) place += std::exchange(counts[k], place);
  return place;
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

void search_near(const ThreeLayers& layers, SearchJob& job, int dimensions) {
  if (dimensions == 2) {
    ScalarSmallerTester<2>(layers, job).search_near();
  } else {
    ScalarSmallerTester<3>(layers, job).search_near();
  }
}

template <int Dim>
void search_far_in(const ThreeLayers& layers, const FarSphere* far, std::size_t count,
                   SearchJob& job) {
  ScalarSmallerTester<Dim> tester(layers, job);
  for (std::size_t k = 0; k < count; ++k) tester.search_far(far[k]);
}

void search_far(const ThreeLayers& layers, const FarSphere* far, std::size_t count, SearchJob& job,
                int dimensions) {
  if (dimensions == 2) {
    search_far_in<2>(layers, far, count, job);
  } else {
    search_far_in<3>(layers, far, count, job);
  }
}

template <int Dim>
void search_coarse_in(const ThreeLayers& layers, const FarSphere* coarse, std::size_t count,
                      SearchJob& job) {
  ScalarCoarseTester<Dim> tester(layers, job);
  for (std::size_t k = 0; k < count; ++k) tester.search(coarse[k]);
}

void search_coarse(const ThreeLayers& layers, const FarSphere* coarse, std::size_t count,
                   SearchJob& job, int dimensions) {
  if (dimensions == 2) {
    search_coarse_in<2>(layers, coarse, count, job);
  } else {
    search_coarse_in<3>(layers, coarse, count, job);
  }
}

}  // namespace

LayerKernels scalar_layer_kernels() {
  return {count_each_layer, scatter,     count_in_steps, count_entries, turn_into_places, split,
          search,           search_near, search_far,     search_coarse};
}

}  // namespace abut::kernels
