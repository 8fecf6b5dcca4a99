#pragma once

#include "base/array.hpp"
#include "engine/radius_histogram.hpp"
#include "exact/box.hpp"
#include "periodic/image_sink.hpp"
#include "periodic/images.hpp"

namespace abut::engine {

/// Arrays that a periodic domain needs beside those of the engine. Kept from one detection to the
/// next, they make the next one free of allocations.
template <int Dim>
struct PeriodicWorkspace {
  explicit PeriodicWorkspace(base::MemoryMeter& memory)
      : enlarged(base::make_array_for_overwrite<base::Sphere<Dim>>(memory, 0)),
        images(memory),
        moved_boxes(base::make_array_for_overwrite<base::Box<Dim>>(memory, 0)) {}

  base::Array<base::Sphere<Dim>> enlarged;  ///< the elements, where they are too small as given
  Images<Dim> images;
  base::Array<base::Box<Dim>> moved_boxes;  ///< of natives and ghosts
  ImageSink<Dim> image_sink;
  RadiusHistogram histogram;
};

}  // namespace abut::engine
