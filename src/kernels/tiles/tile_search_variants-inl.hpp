// The kernels of one instruction set, from its `TileSearch` and its `PairTester`. Included
// like tile_search-inl.hpp.

/// Calls body with the dimensions and the shape of a tile as constants.
template <class Body>
void with_variant(const TileView& tile, int dimensions, Body body) {
  const auto with_shape = [&](auto dimension) {
    switch (tile.shape) {
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

template <template <int, ElementShape> class PairTester>
void search_with(const TileView& tile, const Layers& layers, SearchJob& job, int dimensions) {
  with_variant(tile, dimensions, [&](auto dimension, auto shape) {
    TileSearch<dimension(), PairTester<dimension(), shape()>>(tile, job).search(layers);
  });
}

template <template <int, ElementShape> class PairTester>
void test_coarse_with(const TileView& tile, SearchJob& job, int dimensions,
                      const CoarseElement& coarse, std::span<const Run> runs) {
  with_variant(tile, dimensions, [&](auto dimension, auto shape) {
    test_coarse<PairTester<dimension(), shape()>>(tile, job, coarse, runs);
  });
}
