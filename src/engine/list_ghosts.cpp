#include "engine/list_ghosts.hpp"

#include <abut/error.hpp>

namespace abut::engine {
namespace {

[[noreturn]] void refuse_number_of_images() {
  throw Error(ErrorCode::limit_exceeded,
              "more than 4294967294 periodic images are within reach of the cell; make the lattice "
              "vectors longer, or elements and margin smaller");
}

/// The numbers of those natives, counted from 0, that may have ghosts; returns how many.
template <int Dim>
std::size_t list_outer(std::span<const base::Sphere<Dim>> natives, const kernels::BrickMap& map,
                       const kernels::ImageKernels& kernels, std::uint32_t* numbers) {
  std::size_t found = 0;
  std::size_t i = kernels.list_outer(natives[0].center, natives.size(), Dim, map, numbers, found);
  for (; i < natives.size(); ++i) {
    bool outer = false;
    for (std::size_t k = 0; k < map.sides; ++k) {
      outer = outer || kernels::coordinate<Dim>(map, k, natives[i].center) <= map.outer_below[k];
    }
    numbers[found] = static_cast<std::uint32_t>(i);
    found += outer ? 1 : 0;
  }
  return found;
}

}  // namespace

/// A bound from the widest window; where it is too large, the exact number.
template <int Dim>
void require_countable(std::span<const base::Sphere<Dim>> natives,
                       const grid::GhostWindow<Dim>& window) {
  for (std::size_t k = 0; k < window.sides(); ++k) {
    if (!(window.most_cells(k) <= grid::most_cells_away)) refuse_number_of_images();
  }
  double count = static_cast<double>(natives.size());
  if (count * window.most_images() <= most_natives_and_ghosts) return;
  for (const base::Sphere<Dim>& native : natives) {
    window.for_each_row(native, [&](std::int64_t first, std::int64_t last, const auto&) {
      count += static_cast<double>(last - first + 1);
      if (count > most_natives_and_ghosts) refuse_number_of_images();
    });
  }
}

template <int Dim>
void list_ghosts(std::span<const base::Sphere<Dim>> natives, std::size_t first_number,
                 const kernels::BrickMap& map, const grid::GhostWindow<Dim>& window,
                 const kernels::ImageKernels& kernels, base::Array<Ghost>& ghosts) {
  std::array<std::uint32_t, ghost_block + kernels::most_lanes> outer;
  const std::size_t count = list_outer(natives, map, kernels, outer.data());
  for (std::size_t k = 0; k < count; ++k) {
    Ghost ghost{static_cast<std::uint32_t>(first_number + outer[k]), {}};
    window.for_each_row(natives[outer[k]],
                        [&](std::int64_t first, std::int64_t last, const grid::ImageNumbers& row) {
                          for (std::size_t side = 0; side < 3; ++side) {
                            ghost.image[side] = static_cast<std::int32_t>(row[side]);
                          }
                          for (std::int64_t m = first; m <= last; ++m) {
                            ghost.image[window.sides() - 1] = static_cast<std::int32_t>(m);
                            ghosts.push_back(ghost);
                          }
                        });
  }
}

template void require_countable(std::span<const base::Sphere<2>>, const grid::GhostWindow<2>&);
template void require_countable(std::span<const base::Sphere<3>>, const grid::GhostWindow<3>&);
template void list_ghosts(std::span<const base::Sphere<2>>, std::size_t, const kernels::BrickMap&,
                          const grid::GhostWindow<2>&, const kernels::ImageKernels&,
                          base::Array<Ghost>&);
template void list_ghosts(std::span<const base::Sphere<3>>, std::size_t, const kernels::BrickMap&,
                          const grid::GhostWindow<3>&, const kernels::ImageKernels&,
                          base::Array<Ghost>&);

}  // namespace abut::engine
