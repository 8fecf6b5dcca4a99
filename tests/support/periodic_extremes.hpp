#pragma once

#include "scenes/scene.hpp"

#include <abut/domain.hpp>

#include <array>
#include <cstdint>
#include <string_view>

/// Small periodic systems at the ends of what numbers can say: every kind of domain with every
/// extreme.
namespace abut::testing {

enum class DomainKind : std::uint8_t {
  open,
  one_axis,
  two_axes,
  all_axes,
  triclinic,       ///< oblique vectors, no side along an axis of space
  one_oblique,     ///< a single vector that leads along all axes
  lees_edwards,    ///< a sheared block, many cells far
  small_cell,      ///< one vector far shorter than the reach
  long_cell,       ///< one axis by 2^10 to 2^100 longer than the others
  long_triclinic,  ///< the same, with sides that lean over
};
inline constexpr std::array domain_kinds{DomainKind::open,         DomainKind::one_axis,
                                         DomainKind::two_axes,     DomainKind::all_axes,
                                         DomainKind::triclinic,    DomainKind::one_oblique,
                                         DomainKind::lees_edwards, DomainKind::small_cell,
                                         DomainKind::long_cell,    DomainKind::long_triclinic};

enum class Extreme : std::uint8_t {
  none,
  stray,           ///< elements up to 2^1020 out on an open axis
  far_cells,       ///< elements up to 2^30 cells out along lattice vectors
  scale,           ///< all numbers times 2^-1074 to 2^1020
  flat,            ///< an extent of zero, or of 2^-60 of the cell, on some axis
  ratio,           ///< radii that differ by up to 2^60
  stray_and_scale  ///< both
};
inline constexpr std::array extremes{Extreme::none,           Extreme::stray, Extreme::far_cells,
                                     Extreme::scale,          Extreme::flat,  Extreme::ratio,
                                     Extreme::stray_and_scale};

[[nodiscard]] std::string_view name_of(DomainKind kind);
[[nodiscard]] std::string_view name_of(Extreme extreme);

struct ExtremeSystem {
  scenes::Scene scene;
  Domain domain = Domain::open();
  double margin = 0.0;
};

/// The same system for the same arguments. Coordinates are multiples of few numbers, so that many
/// pairs touch exactly, also across faces of the cell.
[[nodiscard]] ExtremeSystem extreme_system(DomainKind kind, Extreme extreme, int dimensions,
                                           std::size_t count, std::uint64_t seed);

}  // namespace abut::testing
