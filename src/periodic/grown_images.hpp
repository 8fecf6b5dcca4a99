#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "exact/elements.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "periodic/images.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace abut::periodic {

/// Locals and ghosts as near to where they are as doubles can tell, each grown by what it is off
/// itself. In a cell so wide that the largest of these errors, which Images::slack() is, is no
/// small part of a reach, elements near the origin are known far better than that.
///
/// Elements that were not moved are what they were given as. Of the others, what is within reach
/// lies within reach as grown; of what does, Images' elements are decided on (DecidingSink).
template <int Dim>
class GrownImages {
 public:
  explicit GrownImages(base::MemoryMeter& memory);

  /// Places the locals and ghosts of `images`, whose elements are given as those, not times a unit.
  void place(const exact::Elements<Dim>& originals, const Images<Dim>& images, std::size_t workers,
             base::WorkCounter& work);

  /// Locals, then ghosts; if there are boxes, the spheres stand for them.
  [[nodiscard]] exact::Elements<Dim> elements() const noexcept { return {spheres_, boxes_}; }
  /// Bounds of the spheres.
  [[nodiscard]] const grid::Bounds<Dim>& bounds() const noexcept { return bounds_; }

 private:
  void place(std::size_t k, const exact::Elements<Dim>& originals, const Images<Dim>& images);

  base::Array<exact::Sphere<Dim>> spheres_;
  base::Array<exact::Box<Dim>> boxes_;
  grid::Bounds<Dim> bounds_;
  std::vector<grid::Bounds<Dim>> bounds_of_workers_;
};

}  // namespace abut::periodic
