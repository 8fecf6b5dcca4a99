#pragma once

#include "base/host_device.hpp"
#include "device/bodies/check.hpp"
#include "device/overview.hpp"
#include "lattice/cell_extent.hpp"

#include <cstdint>

namespace abut::device {

/// What the host must know of elements in a domain, in a periodic one of their images, too, before
/// it knows what to do with them.
template <int Dim>
struct DomainNumbers {
  Overview<Dim> overview;
  lattice::CellExtent<Dim> in_cell;  ///< of the elements as given, where they have images
  std::uint32_t missing_group;       ///< the number of an element, or no_element
  std::uint32_t unused;              ///< no byte is copied that nobody wrote
};

/// What it must know of locals and ghosts before these are written.
template <int Dim>
struct GhostNumbers {
  Overview<Dim> overview;
  std::uint64_t ghosts;
};

/// Body: sets what is written in few cases.
template <int Dim>
struct ClearDomainNumbers {
  DomainNumbers<Dim>* numbers;

  ABUT_HD void operator()(std::uint64_t) const noexcept {
    numbers->in_cell = {};
    numbers->missing_group = no_element;
    numbers->unused = 0;
  }
};

}  // namespace abut::device
