#pragma once

#include "base/array.hpp"
#include "engine/sizes/radius_histogram.hpp"
#include "exact/box.hpp"
#include "periodic/deciding_sink.hpp"
#include "periodic/grown_images.hpp"
#include "periodic/image_sink.hpp"
#include "periodic/images.hpp"

namespace abut::periodic {

/// Arrays that a periodic domain needs beside those of the engine. Kept from one detection to the
/// next, they make the next one free of allocations.
template <int Dim>
struct PeriodicWorkspace {
  explicit PeriodicWorkspace(base::MemoryMeter& memory)
      : enlarged(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
        images(memory),
        moved_boxes(base::make_array_for_overwrite<exact::Box<Dim>>(memory, 0)),
        grown(memory) {}

  base::Array<exact::Sphere<Dim>> enlarged;  ///< the elements, where they are too small as given
  Images<Dim> images;
  base::Array<exact::Box<Dim>> moved_boxes;  ///< of locals and ghosts
  GrownImages<Dim> grown;
  ImageSink<Dim> image_sink;
  DecidingSink<Dim> deciding_sink;
  engine::RadiusHistogram histogram;
};

}  // namespace abut::periodic
