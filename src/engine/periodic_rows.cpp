#include "engine/periodic_rows.hpp"

#include "engine/arbiter.hpp"
#include "engine/group_search.hpp"
#include "grid/reduced_lattice.hpp"

namespace abut::engine {
namespace {

/// With so many ghosts for each native the reach is about as long as the cell or longer, and a
/// native is within reach of a good part of them: no grid would help.
constexpr std::size_t ghosts_of_long_reach = 16;

/// Every native against the natives behind it and every ghost, each decided on the caller's
/// numbers.
template <int Dim>
void check_all(const Task<Dim>& task, std::size_t natives, base::DetectionContext& context) {
  base::PairWriter pairs(task.sink);
  const auto all = static_cast<std::uint32_t>(task.elements.size());
  for (std::uint32_t i = 0; i < natives; ++i) {
    context.progress.at(i);
    context.candidate_tests += all - i - 1;
    for (std::uint32_t other = i + 1; other < all; ++other) {
      if (task.arbiter.within_reach(i, other, context.exact_decisions)) pairs.push({i, other});
    }
  }
  pairs.finish();
}

/// Takes the ghosts away again that were appended to elements.
template <int Dim>
class Appendix {
 public:
  explicit Appendix(base::Array<base::Sphere<Dim>>& elements)
      : elements_(elements), size_(elements.size()) {}
  ~Appendix() { elements_.resize(size_); }

  Appendix(const Appendix&) = delete;
  Appendix& operator=(const Appendix&) = delete;

 private:
  base::Array<base::Sphere<Dim>>& elements_;
  std::size_t size_;
};

}  // namespace

template <int Dim>
void periodic_rows(base::Array<base::Sphere<Dim>>& elements, const grid::Bounds<Dim>& bounds,
                   const base::Lattice& lattice, const RowsSettings& settings,
                   Workspace<Dim>& workspace, base::PairSink& sink,
                   base::DetectionContext& context) {
  const std::size_t natives = elements.size();
  const Appendix<Dim> appendix(elements);
  const grid::ReducedLattice<Dim> reduced(lattice);
  Images<Dim>& images = workspace.images;
  images.find(elements, bounds, reduced,
              {settings.margin, settings.workers, kernels::image_kernels(settings.simd)});

  ImageSink<Dim>& image_sink = workspace.image_sink;
  image_sink.start_anew(sink, images);
  image_sink.expect_workers(settings.workers);
  const auto originals = std::span<const base::Sphere<Dim>>(elements).first(natives);
  const PeriodicArbiter<Dim> arbiter(originals, lattice, images, settings.margin);
  Group<Dim> group;
  group.bounds = images.bounds();
  group.natives = Numbers(images.natives_and_ghosts().size());
  const Task<Dim> task{{images.natives_and_ghosts(), {}},
                       arbiter,
                       settings.margin * images.unit(),
                       images.least_cell(),
                       kernels::tile_kernels(settings.simd),
                       kernels::element_kernels(settings.simd),
                       image_sink,
                       context.progress};
  if (images.ghosts().size() > ghosts_of_long_reach * natives) {
    return check_all(task, natives, context);
  }
  GroupSearch<Dim>(task, workspace, settings.workers, context).search(group);
}

template void periodic_rows(base::Array<base::Sphere<2>>&, const grid::Bounds<2>&,
                            const base::Lattice&, const RowsSettings&, Workspace<2>&,
                            base::PairSink&, base::DetectionContext&);
template void periodic_rows(base::Array<base::Sphere<3>>&, const grid::Bounds<3>&,
                            const base::Lattice&, const RowsSettings&, Workspace<3>&,
                            base::PairSink&, base::DetectionContext&);

}  // namespace abut::engine
