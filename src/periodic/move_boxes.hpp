#pragma once

#include "base/array.hpp"
#include "exact/box.hpp"
#include "periodic/images.hpp"

#include <cstddef>
#include <span>

namespace abut::engine {

/// The boxes of natives and ghosts, whose lower corners were moved: times Images::unit(), and their
/// ends off so little that Images::slack() holds for boxes, too
/// (docs/derivations/periodic_images.md, 5).
template <int Dim>
void move_boxes(std::span<const base::Box<Dim>> boxes, const Images<Dim>& images,
                std::size_t workers, base::Array<base::Box<Dim>>& moved);

}  // namespace abut::engine
