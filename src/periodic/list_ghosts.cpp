#include "periodic/list_ghosts.hpp"

#include "lattice/check_range.hpp"

namespace abut::periodic {
namespace {

/// Number of locals between two questions to the hook: no small part of a detection.
constexpr std::size_t ghosts_between_polls = std::size_t{1} << 18;

}  // namespace

template <int Dim>
bool is_long_reach(std::span<const exact::Sphere<Dim>> locals, const GhostWindows<Dim>& windows) {
  // Half of the images at most are ghosts, but for those of large elements.
  if (windows.of_large.most_images() <= 2.0 * ghosts_of_long_reach) return false;
  const double most = ghosts_of_long_reach * static_cast<double>(locals.size());
  double count = 0.0;
  for (const exact::Sphere<Dim>& local : locals) {
    windows.for_each_row(local, [&](std::int64_t first, std::int64_t last, const auto&) {
      count += static_cast<double>(last - first + 1);
      return count <= most;
    });
    if (count > most) return true;
  }
  return false;
}

/// A bound from the widest window; where it is too large, the exact number.
template <int Dim>
void require_countable(std::span<const exact::Sphere<Dim>> locals,
                       const GhostWindows<Dim>& windows) {
  const lattice::GhostWindow<Dim>& window = windows.of_large;
  for (std::size_t k = 0; k < window.sides(); ++k) {
    if (!(window.most_cells(k) <= lattice::most_cells_away)) lattice::refuse_number_of_images();
  }
  double count = static_cast<double>(locals.size());
  if (count * window.most_images() <= lattice::most_locals_and_ghosts) return;
  for (const exact::Sphere<Dim>& local : locals) {
    windows.for_each_row(local, [&](std::int64_t first, std::int64_t last, const auto&) {
      count += static_cast<double>(last - first + 1);
      if (count > lattice::most_locals_and_ghosts) lattice::refuse_number_of_images();
      return true;
    });
  }
}

template <int Dim>
void list_outer(std::span<const exact::Sphere<Dim>> locals, const kernels::OrthogonalCellMap& map,
                const kernels::ImageKernels& kernels, kernels::BlockList& outer) {
  std::size_t k = kernels.list_outer(locals[0].center, locals.size(), Dim, map, outer);
  for (; k < locals.size(); ++k) {
    if (kernels::is_outer<Dim>(map, locals[k].center)) outer.push(k);
  }
}

template <int Dim>
void list_ghosts(std::span<const exact::Sphere<Dim>> locals, const kernels::BlockList& outer,
                 std::size_t first_number, const GhostWindows<Dim>& windows,
                 base::Array<Ghost>& ghosts, base::ProgressReporter* progress) {
  const std::size_t last_side = windows.of_large.sides() - 1;
  for (const std::uint32_t k : std::span(outer.number, outer.count)) {
    Ghost ghost{static_cast<std::uint32_t>(first_number + k), {}};
    windows.for_each_row(
        locals[k], [&](std::int64_t first, std::int64_t last, const lattice::ImageNumbers& row) {
          for (std::size_t side = 0; side < 3; ++side) {
            ghost.image[side] = static_cast<std::int32_t>(row[side]);
          }
          for (std::int64_t m = first; m <= last; ++m) {
            ghost.image[last_side] = static_cast<std::int32_t>(m);
            ghosts.push_back(ghost);
            if (ghosts.size() % ghosts_between_polls != 0) continue;
            if (progress != nullptr) progress->poll();
          }
          return true;
        });
  }
}

template bool is_long_reach(std::span<const exact::Sphere<2>>, const GhostWindows<2>&);
template bool is_long_reach(std::span<const exact::Sphere<3>>, const GhostWindows<3>&);
template void require_countable(std::span<const exact::Sphere<2>>, const GhostWindows<2>&);
template void require_countable(std::span<const exact::Sphere<3>>, const GhostWindows<3>&);
template void list_outer(std::span<const exact::Sphere<2>>, const kernels::OrthogonalCellMap&,
                         const kernels::ImageKernels&, kernels::BlockList&);
template void list_outer(std::span<const exact::Sphere<3>>, const kernels::OrthogonalCellMap&,
                         const kernels::ImageKernels&, kernels::BlockList&);
template void list_ghosts(std::span<const exact::Sphere<2>>, const kernels::BlockList&, std::size_t,
                          const GhostWindows<2>&, base::Array<Ghost>&, base::ProgressReporter*);
template void list_ghosts(std::span<const exact::Sphere<3>>, const kernels::BlockList&, std::size_t,
                          const GhostWindows<3>&, base::Array<Ghost>&, base::ProgressReporter*);

}  // namespace abut::periodic
