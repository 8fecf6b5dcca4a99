// The search in a plane in plain C++: the level `scalar`, and the only one without Highway. The
// same sequence of operations in single precision as in plane_search_simd.cpp.

#include "kernels/plane/plane_search.hpp"
#include "kernels/scalar_probe.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace abut::kernels {
namespace {

template <int Dim, ElementShape Shape>
class ScalarPlaneTester {
 public:
  ScalarPlaneTester(const PlaneView& plane, SearchJob& job) : plane_(plane), job_(job) {}

  void search() {
    for (std::uint32_t k = 0; k < plane_.rows; ++k) {
      const Run row = plane_.row(k);
      for (std::uint32_t p = row.begin; p < row.end; ++p) test(p);
    }
  }

 private:
  void test(std::uint32_t p) {
    const ScalarProbe<Dim, Shape> probe(plane_, job_, p);
    const std::uint32_t span = plane_.span(p);
    test(probe, plane_.ahead(p, span));
    test(probe, plane_.across(p, span));
    if (job_.candidate_tests - tests_at_take_ < tests_between_takes) return;
    tests_at_take_ = job_.candidate_tests;
    job_.take(job_);
  }

  void test(const ScalarProbe<Dim, Shape>& probe, const Run& run) {
    job_.candidate_tests += run.end - run.begin;
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      const ProbeAnswer answer = probe.test(q);
      if (answer != ProbeAnswer::none) push_hit(job_, probe.number(), plane_.number[q], answer);
    }
  }

  const PlaneView& plane_;
  SearchJob& job_;
  std::uint64_t tests_at_take_ = job_.candidate_tests;
};

#include "kernels/element_variants-inl.hpp"

#include "kernels/plane/plane_variants-inl.hpp"

}  // namespace

PlaneKernels scalar_plane_kernels() {
  return {[](const double*, std::size_t, int, const PlaneMap&, float* const*) {
            return std::size_t{0};
          },
          [](const float*, const float*, std::size_t, const PlaneMap&, std::uint32_t*) {
            return std::size_t{0};
          },
          [](const PlaneView& plane, SearchJob& job, int dimensions) {
            search_plane_with<ScalarPlaneTester>(plane, job, dimensions);
          }};
}

}  // namespace abut::kernels
