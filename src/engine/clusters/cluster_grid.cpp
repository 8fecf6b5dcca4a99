#include "engine/clusters/cluster_grid.hpp"

#include "engine/box_in_cells.hpp"

namespace abut::engine {

template <int Dim>
ClusterGrid<Dim>::ClusterGrid(const grid::Bounds<Dim>& box, double reach, double cells,
                              std::uint32_t begin)
    : lower_(box.lower),
      reaches_(BoxInCells<Dim>(box, reach).cells),
      cells_of_one_(1.0 / cell_for(box, reach, cells)),
      begin_(begin) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const double along = (box.upper[axis] - box.lower[axis]) * cells_of_one_;
    count_[axis] = static_cast<std::uint32_t>(along) + 1;
    size_ *= count_[axis];
  }
}

template class ClusterGrid<2>;
template class ClusterGrid<3>;

}  // namespace abut::engine
