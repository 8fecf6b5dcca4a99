// The kinds of elements that kernels are compiled for, included into the namespace of one
// instruction set: no include guard, and no includes.

/// Calls body with the dimensions and the shape of elements as constants.
template <class Body>
void with_variant(ElementShape its_shape, int dimensions, Body body) {
  const auto with_shape = [&](auto dimension) {
    switch (its_shape) {
      case ElementShape::equal_spheres:
        return body(dimension, std::integral_constant<ElementShape, ElementShape::equal_spheres>());
      case ElementShape::spheres:
        return body(dimension, std::integral_constant<ElementShape, ElementShape::spheres>());
      case ElementShape::boxes:
        return body(dimension, std::integral_constant<ElementShape, ElementShape::boxes>());
    }
  };
  if (dimensions == 2) {
    with_shape(std::integral_constant<int, 2>());
  } else {
    with_shape(std::integral_constant<int, 3>());
  }
}
