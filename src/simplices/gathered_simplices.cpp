#include "simplices/gathered_simplices.hpp"

#include "base/asking_workers.hpp"
#include "base/workers.hpp"
#include "walls/cell_vertices.hpp"

#include <algorithm>

namespace abut::simplices {
namespace {

template <int Dim>
exact::Box<Dim> box_around(const exact::Simplex<Dim>& simplex) noexcept {
  exact::Box<Dim> box{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    box.lower[axis] = box.upper[axis] = simplex.vertices[0][axis];
    for (std::size_t k = 1; k < simplex.size; ++k) {
      box.lower[axis] = std::min(box.lower[axis], simplex.vertices[k][axis]);
      box.upper[axis] = std::max(box.upper[axis], simplex.vertices[k][axis]);
    }
  }
  return box;
}

}  // namespace

template <int Dim>
exact::Simplex<Dim> simplex_at(const SimplexView& view, std::size_t number) {
  const walls::CellVertices<Dim> vertices(view.vertices(), view.cells());
  exact::Simplex<Dim> simplex{};
  simplex.size = view.cells().vertices_per_cell();
  for (std::size_t k = 0; k < simplex.size; ++k) {
    const exact::Sphere<Dim> vertex = vertices.at(number, k);
    std::copy_n(vertex.center, Dim, simplex.vertices[k].begin());
  }
  return simplex;
}

template <int Dim>
GatheredSimplices<Dim> gather(const SimplexView& view, std::size_t workers,
                              base::DetectionContext& context) {
  GatheredSimplices<Dim> gathered(view, context.memory);
  base::for_each_share(workers, context.work, [&](std::size_t share, base::WorkCounter& work) {
    const auto [first, last] = base::share_of(share, workers, view.size());
    for (std::size_t k = first; k < last; ++k) {
      work.did(4);
      gathered.simplices[k] = simplex_at<Dim>(view, k);
      gathered.boxes[k] = box_around(gathered.simplices[k]);
    }
  });
  return gathered;
}

template exact::Simplex<2> simplex_at(const SimplexView&, std::size_t);
template exact::Simplex<3> simplex_at(const SimplexView&, std::size_t);
template GatheredSimplices<2> gather(const SimplexView&, std::size_t, base::DetectionContext&);
template GatheredSimplices<3> gather(const SimplexView&, std::size_t, base::DetectionContext&);

}  // namespace abut::simplices
