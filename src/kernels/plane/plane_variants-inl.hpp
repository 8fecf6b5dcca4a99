// The kernel of one instruction set, from its `PlaneTester`; included into its namespace behind
// element_variants-inl.hpp: no include guard, and no includes.

template <template <int, ElementShape> class PlaneTester>
void search_plane_with(const PlaneView& plane, SearchJob& job, int dimensions) {
  with_variant(plane.shape, dimensions, [&](auto dimension, auto shape) {
    PlaneTester<dimension(), shape()>(plane, job).search();
  });
}
