#pragma once

#include "api/image_sink.hpp"
#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "base/lattice.hpp"
#include "base/pair_sink.hpp"
#include "engine/rows.hpp"
#include "grid/bounds.hpp"
#include "grid/images.hpp"

#include <cstddef>
#include <span>

namespace abut::api {

/// `rows` in a periodic domain: a search in open space over natives and ghosts, all spheres of one
/// list. It keeps its arrays.
template <int Dim>
class ImageRows {
 public:
  explicit ImageRows(base::MemoryMeter& memory)
      : images_(memory), all_(base::make_array_for_overwrite<base::Sphere<Dim>>(memory, 0)) {}

  void search(std::span<const base::Sphere<Dim>> spheres, const grid::Bounds<Dim>& bounds,
              const base::Lattice& lattice, const engine::RowsSettings& settings,
              engine::Workspace<Dim>& workspace, base::PairSink& sink,
              base::DetectionContext& context);

 private:
  /// Natives, then ghosts, whose radii become longer by the slack.
  void place_all(double ghost_slack, std::size_t workers);

  grid::Images<Dim> images_;
  base::Array<base::Sphere<Dim>> all_;
  grid::Bounds<Dim> bounds_;  ///< of all
  ImageSink<Dim> sink_;
};

}  // namespace abut::api
