// The kernels of one instruction set, from its `TileSearch` and its `Meeting`. Included
// like tile_search-inl.hpp.

template <template <int, bool> class Meeting>
void search_with(const TileView& tile, SearchJob& job, int dimensions) {
  const bool equal_radii = tile.common_radius >= 0.0f;
  if (dimensions == 2) {
    equal_radii ? TileSearch<2, Meeting<2, true>>(tile, job).search()
                : TileSearch<2, Meeting<2, false>>(tile, job).search();
  } else {
    equal_radii ? TileSearch<3, Meeting<3, true>>(tile, job).search()
                : TileSearch<3, Meeting<3, false>>(tile, job).search();
  }
}

template <template <int, bool> class Meeting>
void visit_with(const TileView& tile, SearchJob& job, int dimensions, const Visitor& visitor,
                std::span<const Run> runs) {
  const bool equal_radii = tile.common_radius >= 0.0f;
  if (dimensions == 2) {
    equal_radii ? visit<Meeting<2, true>>(tile, job, visitor, runs)
                : visit<Meeting<2, false>>(tile, job, visitor, runs);
  } else {
    equal_radii ? visit<Meeting<3, true>>(tile, job, visitor, runs)
                : visit<Meeting<3, false>>(tile, job, visitor, runs);
  }
}
