#pragma once

#include "base/array.hpp"
#include "exact/box.hpp"
#include "periodic/images.hpp"

#include <cstddef>
#include <span>

namespace abut::periodic {

/// The boxes of locals and ghosts, whose lower corners were moved: times Images::unit(), and their
/// ends off so little that Images::slack() holds for boxes, too
/// (docs/derivations/periodic_images.md, 5).
template <int Dim>
void move_boxes(std::span<const exact::Box<Dim>> boxes, const Images<Dim>& images,
                std::size_t workers, base::Array<exact::Box<Dim>>& moved);

}  // namespace abut::periodic
