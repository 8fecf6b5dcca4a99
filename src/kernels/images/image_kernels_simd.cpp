// The passes over the elements of a periodic domain in vectors, compiled once for each instruction
// set (Highway). The same operations on the same numbers as in plain C++, hence the same bits.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/images/image_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/compress_table.hpp"
#include "kernels/images/image_kernels.hpp"
#include "kernels/table_index.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_sphere_columns-inl.hpp"

constexpr std::size_t lanes = hn::MaxLanes(DoubleTag());
static_assert(BlockList::room + lanes <= sizeof(BlockList::number) / sizeof(std::uint32_t));

/// lattice::CellSides::coordinate.
template <int Dim>
HWY_INLINE Doubles coordinate(const double* coefficients, const Doubles* center) {
  Doubles sum = hn::Mul(hn::Set(doubles, coefficients[0]), center[0]);
  for (int axis = 1; axis < Dim; ++axis) {
    sum = hn::Add(sum, hn::Mul(hn::Set(doubles, coefficients[axis]), center[axis]));
  }
  return sum;
}

using Mask = hn::Mask<DoubleTag>;

/// Appends the numbers of the lanes of the mask, the first of which is `first`, to those that end
/// before `end`; returns their new end. Without a branch, for who is listed cannot be foreseen.
template <class D>
HWY_INLINE std::uint32_t* list_lanes(D d, hn::Mask<D> mask, std::size_t first, std::uint32_t* end) {
  constexpr hn::Rebind<std::uint32_t, D> numbers;
  constexpr hn::Rebind<std::uint8_t, D> bytes;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, mask, bits);
  const auto listed = hn::PromoteTo(numbers, hn::LoadU(bytes, compress_table[bits[0]].data()));
  hn::StoreU(hn::Add(listed, hn::Set(numbers, static_cast<std::uint32_t>(first))), numbers, end);
  return end + hwy::PopCount(bits[0]);
}

/// The outer ones of a vector of records.
template <int Dim, std::size_t Sides>
HWY_INLINE Mask outer_lanes(const CellSideMap& map, const Doubles* center, Doubles radius) {
  Mask outer = hn::Ge(radius, hn::Set(doubles, map.outer_from_radius));
  for (std::size_t k = 0; k < Sides; ++k) {
    outer = hn::Or(outer, hn::Le(coordinate<Dim>(map.coefficients[k], center),
                                 hn::Set(doubles, map.outer_below[k])));
  }
  return outer;
}

template <int Dim, std::size_t Sides, class Spheres>
std::size_t wrap_in(const Spheres& spheres, std::size_t first, std::size_t count,
                    const CellSideMap& given, double* locals, void* cells_moved,
                    CenterBounds& bounds, BlockList& outer) {
  const CellSideMap map = given;  // a copy that nothing can change
  std::uint32_t* end_of_outer = outer.number + outer.count;
  const hn::Rebind<std::int32_t, DoubleTag> integers;
  auto* const out = static_cast<std::int32_t*>(cells_moved);
  Doubles lower[Dim];
  Doubles upper[Dim];
  for (int axis = 0; axis < Dim; ++axis) {
    lower[axis] = hn::Set(doubles, bounds.lower[axis]);
    upper[axis] = hn::Set(doubles, bounds.upper[axis]);
  }
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    Doubles center[Dim];
    Doubles radius;
    spheres.load(first + i, center, radius);
    Doubles cells[3] = {hn::Zero(doubles), hn::Zero(doubles), hn::Zero(doubles)};
    for (std::size_t k = 0; k < Sides; ++k) {
      if (!map.along[k]) continue;
      Doubles place = coordinate<Dim>(map.coefficients[k], center);
      for (std::size_t l = 0; l < k; ++l) {
        place = hn::Sub(place, hn::Mul(cells[l], hn::Set(doubles, map.offset[l][k])));
      }
      cells[k] = hn::Floor(place);
    }
    for (int axis = 0; axis < Dim; ++axis) {
      for (std::size_t k = 0; k < Sides; ++k) {
        center[axis] =
            hn::Sub(center[axis], hn::Mul(cells[k], hn::Set(doubles, map.vectors[k][axis])));
      }
      lower[axis] = hn::Min(lower[axis], center[axis]);
      upper[axis] = hn::Max(upper[axis], center[axis]);
    }
    end_of_outer =
        list_lanes(doubles, outer_lanes<Dim, Sides>(map, center, radius), i, end_of_outer);
    if constexpr (Dim == 2) {
      hn::StoreInterleaved3(center[0], center[1], radius, doubles, locals + i * 3);
    } else {
      hn::StoreInterleaved4(center[0], center[1], center[2], radius, doubles, locals + i * 4);
    }
    if (map.pack) {
      const Doubles zero = hn::Set(doubles, 512.0);
      const Doubles width = hn::Set(doubles, 1024.0);
      Doubles word = hn::Add(cells[0], zero);
      word = hn::Add(hn::Mul(word, width), hn::Add(cells[1], zero));
      word = hn::Add(hn::Mul(word, width), hn::Add(cells[2], zero));
      hn::StoreU(hn::DemoteTo(integers, word), integers, out + i);
    } else {
      hn::StoreInterleaved3(hn::DemoteTo(integers, cells[0]), hn::DemoteTo(integers, cells[1]),
                            hn::DemoteTo(integers, cells[2]), integers, out + i * 3);
    }
  }
  for (int axis = 0; axis < Dim; ++axis) {
    bounds.lower[axis] = hn::GetLane(hn::MinOfLanes(doubles, lower[axis]));
    bounds.upper[axis] = hn::GetLane(hn::MaxOfLanes(doubles, upper[axis]));
  }
  outer.count = static_cast<std::size_t>(end_of_outer - outer.number);
  return i;
}

template <int Dim, std::size_t Sides, class Spheres>
std::size_t list_outer_in(const Spheres& spheres, std::size_t first, std::size_t count,
                          const CellSideMap& given, BlockList& outer) {
  const CellSideMap map = given;  // a copy that nothing can change
  std::uint32_t* end = outer.number + outer.count;
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    Doubles center[Dim];
    Doubles radius;
    spheres.load(first + i, center, radius);
    end = list_lanes(doubles, outer_lanes<Dim, Sides>(map, center, radius), i, end);
  }
  outer.count = static_cast<std::size_t>(end - outer.number);
  return i;
}

/// The sides of a cell that lie along the axes, by axis: which elements are outer if no radius
/// makes them so.
template <int Dim>
class SidesOfBlock {
 public:
  explicit SidesOfBlock(const CellSideMap& map) {
    std::fill_n(below_, Dim, -std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < map.sides; ++k) {
      std::size_t axis = 0;
      while (axis + 1 < Dim && map.coefficients[k][axis] == 0.0) ++axis;
      coefficient_[axis] = map.coefficients[k][axis];
      below_[axis] = map.outer_below[k];
    }
  }

  [[nodiscard]] static bool fit(const CellSideMap& map) {
    for (std::size_t k = 0; k < map.sides; ++k) {
      const double* const by_axis = map.coefficients[k];
      if (std::count(by_axis, by_axis + Dim, 0.0) != Dim - 1) return false;
    }
    return map.outer_from_radius == std::numeric_limits<double>::infinity();
  }

  HWY_INLINE Mask outer_lanes(const Doubles* center) const {
    Mask outer = outer_lanes(0, center[0]);
    for (int axis = 1; axis < Dim; ++axis) {
      outer = hn::Or(outer, outer_lanes(axis, center[axis]));
    }
    return outer;
  }

 private:
  [[nodiscard]] HWY_INLINE Mask outer_lanes(int axis, Doubles x) const {
    return hn::Le(hn::Mul(hn::Set(doubles, coefficient_[axis]), x), hn::Set(doubles, below_[axis]));
  }

  double coefficient_[Dim] = {};
  double below_[Dim];
};

template <int Dim, class Spheres>
std::size_t list_outer_of_block(const Spheres& spheres, std::size_t first, std::size_t count,
                                const CellSideMap& map, BlockList& outer) {
  const SidesOfBlock<Dim> sides(map);
  std::uint32_t* end = outer.number + outer.count;
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    Doubles center[Dim];
    spheres.load_center(first + i, center);
    end = list_lanes(doubles, sides.outer_lanes(center), i, end);
  }
  outer.count = static_cast<std::size_t>(end - outer.number);
  return i;
}

template <int Dim, std::size_t Sides, class Spheres>
std::size_t bound_sides_in(const Spheres& spheres, std::size_t first, std::size_t count,
                           const CellSideMap& given, CenterBounds& bounds) {
  const CellSideMap map = given;  // a copy that nothing can change
  Doubles lower[Sides];
  Doubles upper[Sides];
  for (std::size_t k = 0; k < Sides; ++k) {
    lower[k] = hn::Set(doubles, bounds.lower[k]);
    upper[k] = hn::Set(doubles, bounds.upper[k]);
  }
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    Doubles center[Dim];
    spheres.load_center(first + i, center);
    for (std::size_t k = 0; k < Sides; ++k) {
      const Doubles place = coordinate<Dim>(map.coefficients[k], center);
      lower[k] = hn::Min(lower[k], place);
      upper[k] = hn::Max(upper[k], place);
    }
  }
  for (std::size_t k = 0; k < Sides; ++k) {
    bounds.lower[k] = hn::GetLane(hn::MinOfLanes(doubles, lower[k]));
    bounds.upper[k] = hn::GetLane(hn::MaxOfLanes(doubles, upper[k]));
  }
  return i;
}

/// Returns body(loader, sides) for the loader that reads such spheres, and the number of sides as
/// a constant.
template <int Dim, class Body>
std::size_t with_sides(const StridedSpheres& spheres, std::size_t sides, const Body& body) {
  return with_loader<Dim>(spheres, [&](const auto& loader) {
    if (sides == 1) return body(loader, std::integral_constant<std::size_t, 1>());
    if (Dim == 2 || sides == 2) return body(loader, std::integral_constant<std::size_t, 2>());
    return body(loader, std::integral_constant<std::size_t, Dim>());
  });
}

std::size_t wrap(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                 int dimensions, const CellSideMap& map, double* locals, void* cells,
                 CenterBounds& bounds, BlockList& outer) {
  return with_dimensions(dimensions, [&](auto dim) {
    return with_sides<dim()>(spheres, map.sides, [&](const auto& loader, auto sides) {
      return wrap_in<dim(), sides()>(loader, first, count, map, locals, cells, bounds, outer);
    });
  });
}

std::size_t list_outer(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                       int dimensions, const CellSideMap& map, BlockList& outer) {
  return with_dimensions(dimensions, [&](auto dim) {
    if (SidesOfBlock<dim()>::fit(map)) {
      return with_loader<dim()>(spheres, [&](const auto& loader) {
        return list_outer_of_block<dim()>(loader, first, count, map, outer);
      });
    }
    return with_sides<dim()>(spheres, map.sides, [&](const auto& loader, auto sides) {
      return list_outer_in<dim(), sides()>(loader, first, count, map, outer);
    });
  });
}

std::size_t bound_sides(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                        int dimensions, const CellSideMap& map, CenterBounds& bounds) {
  return with_dimensions(dimensions, [&](auto dim) {
    return with_sides<dim()>(spheres, map.sides, [&](const auto& loader, auto sides) {
      return bound_sides_in<dim(), sides()>(loader, first, count, map, bounds);
    });
  });
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(wrap);
HWY_EXPORT(list_outer);
HWY_EXPORT(bound_sides);

ImageKernels simd_image_kernels(std::int64_t target) {
  const std::size_t level = table_index(target);
  return {HWY_DISPATCH_TABLE(wrap)[level], HWY_DISPATCH_TABLE(list_outer)[level],
          HWY_DISPATCH_TABLE(bound_sides)[level], simd_keep_with_local(target)};
}

}  // namespace abut::kernels
#endif
