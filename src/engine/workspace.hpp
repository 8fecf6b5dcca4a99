#pragma once

#include "base/array.hpp"
#include "base/box.hpp"
#include "engine/bench.hpp"
#include "engine/image_sink.hpp"
#include "engine/images.hpp"
#include "engine/tile_searcher.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace abut::engine {

/// All arrays of the engine. Kept from one detection to the next, it makes the next one free of
/// allocations.
template <int Dim>
struct Workspace {
  explicit Workspace(base::MemoryMeter& meter)
      : memory(meter),
        floors(meter),
        images(meter),
        moved_boxes(base::make_array_for_overwrite<base::Box<Dim>>(meter, 0)) {}

  void expect_workers(std::size_t count) {
    while (workers.size() < count) {
      workers.push_back(std::make_unique<TileSearcher<Dim>>(memory, workers.size()));
    }
  }

  base::MemoryMeter& memory;
  Floors<Dim> floors;  ///< for groups that all workers search together
  std::vector<std::unique_ptr<TileSearcher<Dim>>> workers;
  RadiusHistogram histogram;
  Images<Dim> images;                       ///< of a periodic domain
  base::Array<base::Box<Dim>> moved_boxes;  ///< of its natives and ghosts
  ImageSink<Dim> image_sink;
  std::vector<std::unique_ptr<Members>> deferred;  ///< large groups that wait until all are free
};

}  // namespace abut::engine
