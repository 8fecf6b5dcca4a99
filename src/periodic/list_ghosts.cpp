#include "periodic/list_ghosts.hpp"

#include "lattice/check_range.hpp"

#include <algorithm>

namespace abut::periodic {
namespace {

/// Number of ghosts between two questions to the hook: no small part of a detection.
constexpr std::size_t ghosts_between_polls = std::size_t{1} << 18;

}  // namespace

template <int Dim>
bool is_long_reach(const kernels::StridedSpheres& locals, const GhostWindows<Dim>& windows) {
  // Half of the images at most are ghosts, but for those of large elements.
  if (windows.of_large.most_images() <= 2.0 * ghosts_of_long_reach) return false;
  const double most = ghosts_of_long_reach * static_cast<double>(locals.size);
  double count = 0.0;
  for (std::size_t k = 0; k < locals.size; ++k) {
    const exact::Sphere<Dim> local = kernels::sphere_at<Dim>(locals, k);
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
void require_countable(const kernels::StridedSpheres& locals, const GhostWindows<Dim>& windows) {
  const lattice::GhostWindow<Dim>& window = windows.of_large;
  for (std::size_t k = 0; k < window.sides(); ++k) {
    if (!(window.most_cells(k) <= lattice::most_cells_away)) lattice::refuse_number_of_images();
  }
  double count = static_cast<double>(locals.size);
  if (count * window.most_images() <= lattice::most_locals_and_ghosts) return;
  for (std::size_t k = 0; k < locals.size; ++k) {
    const exact::Sphere<Dim> local = kernels::sphere_at<Dim>(locals, k);
    windows.for_each_row(local, [&](std::int64_t first, std::int64_t last, const auto&) {
      count += static_cast<double>(last - first + 1);
      if (count > lattice::most_locals_and_ghosts) lattice::refuse_number_of_images();
      return true;
    });
  }
}

template <int Dim>
void list_outer(const LocalBlock& block, const kernels::CellSideMap& map,
                const kernels::ImageKernels& kernels, kernels::BlockList& outer) {
  const auto& [locals, first, count] = block;
  std::size_t k = kernels.list_outer(locals, first, count, Dim, map, outer);
  for (; k < count; ++k) {
    if (kernels::is_outer<Dim>(map, kernels::sphere_at<Dim>(locals, first + k))) outer.push(k);
  }
}

template <int Dim>
void list_ghosts(const LocalBlock& block, const kernels::BlockList& outer,
                 const GhostWindows<Dim>& windows, base::Array<Ghost>& ghosts,
                 base::ProgressReporter* progress) {
  const std::size_t last_side = windows.of_large.sides() - 1;
  const std::span numbers(outer.number, outer.count);
  // Radii in an array of their own have not been read yet.
  for (const std::uint32_t k : numbers) {
    __builtin_prefetch(block.locals.place(kernels::StridedSpheres::radii, block.first + k));
  }
  for (const std::uint32_t k : numbers) {
    const std::size_t number = block.first + k;
    const auto list = [&](const lattice::ImageNumbers& image) {
      Ghost& ghost = ghosts.emplace_back();
      ghost.element = static_cast<std::uint32_t>(number);
      std::transform(image.begin(), image.end(), ghost.image.begin(),
                     [](std::int64_t m) { return static_cast<std::int32_t>(m); });
      if (ghosts.size() % ghosts_between_polls == 0 && progress != nullptr) progress->poll();
    };
    const exact::Sphere<Dim> local = kernels::sphere_at<Dim>(block.locals, number);
    lattice::ImageNumbers image{};
    if (local.radius < windows.cut && windows.of_small.has_one_image(local, image)) {
      list(image);
      continue;
    }
    windows.for_each_row(local,
                         [&](std::int64_t first, std::int64_t last, lattice::ImageNumbers row) {
                           std::int64_t& m = row[last_side];
                           for (m = first; m <= last; ++m) list(row);
                           return true;
                         });
  }
}

template bool is_long_reach(const kernels::StridedSpheres&, const GhostWindows<2>&);
template bool is_long_reach(const kernels::StridedSpheres&, const GhostWindows<3>&);
template void require_countable(const kernels::StridedSpheres&, const GhostWindows<2>&);
template void require_countable(const kernels::StridedSpheres&, const GhostWindows<3>&);
template void list_outer<2>(const LocalBlock&, const kernels::CellSideMap&,
                            const kernels::ImageKernels&, kernels::BlockList&);
template void list_outer<3>(const LocalBlock&, const kernels::CellSideMap&,
                            const kernels::ImageKernels&, kernels::BlockList&);
template void list_ghosts(const LocalBlock&, const kernels::BlockList&, const GhostWindows<2>&,
                          base::Array<Ghost>&, base::ProgressReporter*);
template void list_ghosts(const LocalBlock&, const kernels::BlockList&, const GhostWindows<3>&,
                          base::Array<Ghost>&, base::ProgressReporter*);

}  // namespace abut::periodic
