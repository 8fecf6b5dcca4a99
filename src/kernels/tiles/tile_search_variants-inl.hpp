// The kernels of one instruction set, from its `TileSearch` and its `PairTester`. Included
// like tile_search-inl.hpp.

template <template <int, ElementShape> class PairTester>
void search_with(const TileView& tile, const Layers& layers, SearchJob& job, int dimensions) {
  with_variant(tile.shape, dimensions, [&](auto dimension, auto shape) {
    TileSearch<dimension(), PairTester<dimension(), shape()>>(tile, job).search(layers);
  });
}

template <template <int, ElementShape> class PairTester>
void test_coarse_with(const TileView& tile, SearchJob& job, int dimensions,
                      const CoarseElement& coarse, std::span<const Run> runs) {
  with_variant(tile.shape, dimensions, [&](auto dimension, auto shape) {
    test_coarse<PairTester<dimension(), shape()>>(tile, job, coarse, runs);
  });
}
