// The kernel of one instruction set, from its `PlaneTester`; included into its namespace: no
// include guard, and no includes.

/// Calls the search of a tester for these dimensions and the shape of the elements.
template <template <int, ElementShape> class PlaneTester>
void search_plane_with(const PlaneView& plane, SearchJob& job, int dimensions) {
  const auto with_shape = [&](auto dimension) {
    constexpr int dim = decltype(dimension)::value;
    switch (plane.shape) {
      case ElementShape::equal_spheres:
        return PlaneTester<dim, ElementShape::equal_spheres>(plane, job).search();
      case ElementShape::spheres:
        return PlaneTester<dim, ElementShape::spheres>(plane, job).search();
      case ElementShape::boxes:
        return PlaneTester<dim, ElementShape::boxes>(plane, job).search();
    }
  };
  if (dimensions == 2) return with_shape(std::integral_constant<int, 2>());
  with_shape(std::integral_constant<int, 3>());
}
