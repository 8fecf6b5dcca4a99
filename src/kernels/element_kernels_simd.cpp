// The passes over all elements in vectors, compiled once for each instruction set (Highway). The
// same operations on the same numbers as in plain C++, hence the same bits.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/element_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/element_kernels.hpp"
#include "kernels/place_format.hpp"
#include "kernels/table_index.hpp"
#include "kernels/tiles/tile_view.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "kernels/simd_sphere_columns-inl.hpp"

using Mask = hn::Mask<DoubleTag>;
constexpr std::size_t lanes = hn::MaxLanes(DoubleTag());

/// Bounds of the elements of each lane.
template <int Dim>
class LaneBounds {
 public:
  HWY_INLINE explicit LaneBounds(const ElementBounds& bounds) {
    for (int axis = 0; axis < Dim; ++axis) {
      lower_[axis] = hn::Set(doubles, bounds.lower[axis]);
      upper_[axis] = hn::Set(doubles, bounds.upper[axis]);
    }
    smallest_ = hn::Set(doubles, bounds.smallest_radius);
    largest_ = second_largest_ = hn::Zero(doubles);
  }

  HWY_INLINE void include(const Doubles* center, Doubles radius) {
    for (int axis = 0; axis < Dim; ++axis) {
      lower_[axis] = hn::Min(lower_[axis], center[axis]);
      upper_[axis] = hn::Max(upper_[axis], center[axis]);
    }
    smallest_ = hn::Min(smallest_, radius);
    second_largest_ = hn::Max(second_largest_, hn::Min(radius, largest_));
    largest_ = hn::Max(largest_, radius);
  }

  void widen(ElementBounds& bounds) const {
    for (int axis = 0; axis < Dim; ++axis) {
      bounds.lower[axis] = hn::GetLane(hn::MinOfLanes(doubles, lower_[axis]));
      bounds.upper[axis] = hn::GetLane(hn::MaxOfLanes(doubles, upper_[axis]));
    }
    bounds.smallest_radius = hn::GetLane(hn::MinOfLanes(doubles, smallest_));
    HWY_ALIGN double largest[2 * lanes];
    hn::Store(largest_, doubles, largest);
    hn::Store(second_largest_, doubles, largest + lanes);
    for (const double radius : largest) {
      const double smaller = radius < bounds.largest_radius ? radius : bounds.largest_radius;
      if (smaller > bounds.second_largest_radius) bounds.second_largest_radius = smaller;
      if (radius > bounds.largest_radius) bounds.largest_radius = radius;
    }
  }

 private:
  Doubles lower_[Dim];
  Doubles upper_[Dim];
  Doubles smallest_;
  Doubles largest_;
  Doubles second_largest_;
};

/// Writes elements as records.
template <int Dim>
class RecordWriter {
 public:
  HWY_INLINE explicit RecordWriter(double* records) : records_(records) {}

  HWY_INLINE void write(std::size_t k, const Doubles* center, Doubles radius) const {
    if constexpr (Dim == 2) {
      hn::StoreInterleaved3(center[0], center[1], radius, doubles, records_ + k * 3);
    } else {
      hn::StoreInterleaved4(center[0], center[1], center[2], radius, doubles, records_ + k * 4);
    }
  }

 private:
  double* records_;
};

/// Leaves nothing but the bounds.
class BoundsWriter {
 public:
  HWY_INLINE void write(std::size_t, const Doubles*, Doubles) const {}
};

/// Widens the bounds by the elements before the first vector with a bad one, and writes them.
template <int Dim, class Spheres, class Writer>
std::size_t read_spheres(const Spheres& spheres, std::size_t first, std::size_t count,
                         ElementBounds& bounds, const Writer& writer) {
  const Doubles largest = hn::Set(doubles, std::numeric_limits<double>::max());
  LaneBounds<Dim> lane_bounds(bounds);
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    Doubles center[Dim];
    Doubles radius;
    spheres.load(first + k, center, radius);
    Mask valid = hn::And(hn::Ge(radius, hn::Zero(doubles)), hn::Le(radius, largest));
    for (int axis = 0; axis < Dim; ++axis) {
      valid = hn::And(valid, hn::Le(hn::Abs(center[axis]), largest));
    }
    if (HWY_UNLIKELY(!hn::AllTrue(doubles, valid))) break;
    lane_bounds.include(center, radius);
    writer.write(k, center, radius);
  }
  if (k > 0) lane_bounds.widen(bounds);
  return k;
}

template <int Dim>
HWY_INLINE void load_records(const double* records, Doubles* center, Doubles& radius) {
  if constexpr (Dim == 2) {
    hn::LoadInterleaved3(doubles, records, center[0], center[1], radius);
  } else {
    hn::LoadInterleaved4(doubles, records, center[0], center[1], center[2], radius);
  }
}

template <int Dim>
HWY_INLINE void load_centers(const double* records, Doubles* center) {
  Doubles radius;
  load_records<Dim>(records, center, radius);
}

template <int Dim>
std::size_t bound_in(const double* records, std::size_t count, ElementBounds& bounds) {
  LaneBounds<Dim> lane_bounds(bounds);
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    Doubles center[Dim];
    Doubles radius;
    load_records<Dim>(records + k * (Dim + 1), center, radius);
    lane_bounds.include(center, radius);
  }
  if (k > 0) lane_bounds.widen(bounds);
  return k;
}

/// Position along an axis in tiles, and the tile: TileGrid::place.
HWY_INLINE Doubles tile_coordinate(const PlaceMap& map, int axis, Doubles x) {
  return hn::Mul(hn::Sub(x, hn::Set(doubles, map.lower[axis])),
                 hn::Set(doubles, map.inverse_size[axis]));
}
HWY_INLINE Doubles tile_of(const PlaceMap& map, int axis, Doubles q) {
  return hn::Min(hn::Trunc(q), hn::Set(doubles, map.last[axis]));
}

template <int Dim>
std::size_t place_in(const double* records, std::size_t count, const PlaceMap& map,
                     std::uint32_t* places) {
  const hn::Rebind<std::int32_t, DoubleTag> integers;
  const hn::RebindToUnsigned<decltype(integers)> numbers;
  const Doubles one = hn::Set(doubles, 1.0);
  // Places have 32 bits; conversion knows signed integers only.
  const Doubles middle = hn::Set(doubles, 0x1p31);
  const auto sign = hn::Set(integers, std::numeric_limits<std::int32_t>::min());
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    Doubles center[Dim];
    load_centers<Dim>(records + k * (Dim + 1), center);
    Doubles tile = hn::Zero(doubles);
    Doubles faces = hn::Zero(doubles);
    for (int axis = 0; axis < Dim; ++axis) {
      const Doubles q = tile_coordinate(map, axis, center[axis]);
      const Doubles t = tile_of(map, axis, q);
      const Doubles within = hn::Sub(q, t);
      const Doubles border = hn::Set(doubles, map.border[axis]);
      const auto lower_bit = static_cast<double>(1 << (2 * axis));
      faces =
          hn::Add(faces, hn::IfThenElseZero(hn::Le(within, border), hn::Set(doubles, lower_bit)));
      faces = hn::Add(faces, hn::IfThenElseZero(hn::Ge(within, hn::Sub(one, border)),
                                                hn::Set(doubles, 2.0 * lower_bit)));
      tile = hn::Add(tile, hn::Mul(hn::Add(t, one), hn::Set(doubles, map.stride[axis])));
    }
    const Doubles place =
        hn::Add(hn::Mul(tile, hn::Set(doubles, double{1 << place_face_bits})), faces);
    const auto shifted = hn::Xor(hn::DemoteTo(integers, hn::Sub(place, middle)), sign);
    hn::StoreU(hn::BitCast(numbers, shifted), numbers, places + k);
  }
  return k;
}

/// Four 32-bit numbers, or eight, as the lanes of doubles or the widest vector say.
using SingleTag = hn::Rebind<float, DoubleTag>;
using WordTag = hn::RebindToUnsigned<SingleTag>;

template <int Dim>
std::size_t record_in(const double* records, std::size_t count, const RecordMap& map,
                      std::uint32_t first_number, void* tile_records) {
  constexpr SingleTag singles{};
  constexpr WordTag words{};
  auto* const out = static_cast<std::uint32_t*>(tile_records);
  auto number = hn::Iota(words, first_number);
  const auto step = hn::Set(words, static_cast<std::uint32_t>(lanes));
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    Doubles center[Dim];
    load_centers<Dim>(records + k * (Dim + 1), center);
    hn::Vec<WordTag> words_of[Dim];
    for (int axis = 0; axis < Dim; ++axis) {
      const Doubles q = tile_coordinate(map.place, axis, center[axis]);
      const Doubles within = hn::Sub(q, tile_of(map.place, axis, q));
      const Doubles position = hn::Mul(within, hn::Set(doubles, map.scale[axis]));
      words_of[axis] = hn::BitCast(words, hn::DemoteTo(singles, position));
    }
    if constexpr (Dim == 2) {
      hn::StoreInterleaved3(words_of[0], words_of[1], number, words, out + k * 3);
    } else {
      hn::StoreInterleaved4(words_of[0], words_of[1], words_of[2], number, words, out + k * 4);
    }
    number = hn::Add(number, step);
  }
  return k;
}

template <int Dim>
std::size_t bin_in(const void* tile_records, std::size_t count, const CellMap& map,
                   std::uint32_t* cells) {
  using FloatTag = hn::ScalableTag<float>;
  constexpr FloatTag floats{};
  const hn::RebindToSigned<FloatTag> integers;
  const hn::RebindToUnsigned<FloatTag> numbers;
  constexpr std::size_t wide = hn::MaxLanes(FloatTag());
  const auto* const in = static_cast<const float*>(tile_records);
  const auto one = hn::Set(floats, 1.0f);
  std::size_t k = 0;
  for (; k + wide <= count; k += wide) {
    hn::Vec<FloatTag> center[3];
    hn::Vec<FloatTag> number;
    if constexpr (Dim == 2) {
      hn::LoadInterleaved3(floats, in + k * 3, center[0], center[1], number);
    } else {
      hn::LoadInterleaved4(floats, in + k * 4, center[0], center[1], center[2], number);
    }
    auto cell = hn::Zero(integers);
    for (int axis = 0; axis < Dim; ++axis) {
      const auto q = hn::Add(hn::Mul(center[axis], hn::Set(floats, map.per_unit[axis])), one);
      const auto clamped = hn::Min(hn::Max(q, one), hn::Set(floats, map.last[axis]));
      cell = hn::Add(
          cell, hn::Mul(hn::ConvertTo(integers, clamped), hn::Set(integers, map.stride[axis])));
    }
    hn::StoreU(hn::BitCast(numbers, cell), numbers, cells + k);
  }
  return k;
}

#if HWY_TARGET == HWY_SCALAR
template <int Dim>
std::size_t arrange_in(const Arrangement&) {
  return 0;
}
#else
/// Four records of (Dim + 1) numbers become Dim + 1 columns of four.
template <int Dim>
std::size_t arrange_in(const Arrangement& job) {
  using QuadTag = hn::CappedTag<std::uint32_t, 4>;
  constexpr QuadTag quads{};
  static_assert(hn::MaxLanes(QuadTag()) == 4);
  const hn::RepartitionToWide<QuadTag> pairs;
  const auto* const records = static_cast<const std::uint32_t*>(job.tile_records);
  const auto record = [&](std::uint32_t k) { return hn::LoadU(quads, records + k * (Dim + 1)); };
  const auto joined_lower = [&](auto a, auto b) {
    return hn::BitCast(quads,
                       hn::InterleaveLower(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b)));
  };
  const auto joined_upper = [&](auto a, auto b) {
    return hn::BitCast(quads,
                       hn::InterleaveUpper(pairs, hn::BitCast(pairs, a), hn::BitCast(pairs, b)));
  };
  const hn::RebindToFloat<QuadTag> singles;
  const auto store = [&](auto column, float* to) {
    hn::StoreU(hn::BitCast(singles, column), singles, to);
  };
  const auto far = hn::Set(singles, far_away);
  for (std::size_t row = 0; row < job.row_count; ++row) {
    const std::uint32_t begin = job.cell_begin[row * job.row_length];
    const std::uint32_t end = job.cell_begin[(row + 1) * job.row_length - 1];
    hn::StoreU(hn::Zero(quads), quads, job.order + end);
    for (std::uint32_t place = begin; place < end; place += 4) {
      const std::uint32_t* const order = job.order + place;
      const auto a = record(order[0]);
      const auto b = record(order[1]);
      const auto c = record(order[2]);
      const auto d = record(order[3]);
      const auto ab = hn::InterleaveLower(quads, a, b);
      const auto cd = hn::InterleaveLower(quads, c, d);
      store(joined_lower(ab, cd), job.center[0] + place);
      store(joined_upper(ab, cd), job.center[1] + place);
      const auto ab_upper = hn::InterleaveUpper(quads, a, b);
      const auto cd_upper = hn::InterleaveUpper(quads, c, d);
      const auto third = joined_lower(ab_upper, cd_upper);
      if constexpr (Dim == 2) {
        hn::StoreU(third, quads, job.number + place);
      } else {
        store(third, job.center[2] + place);
        hn::StoreU(joined_upper(ab_upper, cd_upper), quads, job.number + place);
      }
    }
    for (std::uint32_t k = 0; k < row_padding; k += 4)
      hn::StoreU(far, singles, job.center[0] + end + k);
  }
  return job.row_count;
}
#endif

std::size_t pack(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                 int dimensions, double* records, ElementBounds& bounds) {
  return with_dimensions(dimensions, [&](auto dim) {
    return with_loader<dim()>(spheres, [&](const auto& loader) {
      return read_spheres<dim()>(loader, first, count, bounds, RecordWriter<dim()>(records));
    });
  });
}

std::size_t check(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                  int dimensions, ElementBounds& bounds) {
  return with_dimensions(dimensions, [&](auto dim) {
    return with_loader<dim()>(spheres, [&](const auto& loader) {
      return read_spheres<dim()>(loader, first, count, bounds, BoundsWriter());
    });
  });
}

std::size_t bound(const double* records, std::size_t count, int dimensions, ElementBounds& bounds) {
  return dimensions == 2 ? bound_in<2>(records, count, bounds)
                         : bound_in<3>(records, count, bounds);
}

std::size_t place(const double* records, std::size_t count, int dimensions, const PlaceMap& map,
                  std::uint32_t* places) {
  return dimensions == 2 ? place_in<2>(records, count, map, places)
                         : place_in<3>(records, count, map, places);
}

std::size_t record(const double* records, std::size_t count, int dimensions, const RecordMap& map,
                   std::uint32_t first_number, void* tile_records) {
  return dimensions == 2 ? record_in<2>(records, count, map, first_number, tile_records)
                         : record_in<3>(records, count, map, first_number, tile_records);
}

std::size_t bin(const void* tile_records, std::size_t count, int dimensions, const CellMap& map,
                std::uint32_t* cells) {
  return dimensions == 2 ? bin_in<2>(tile_records, count, map, cells)
                         : bin_in<3>(tile_records, count, map, cells);
}

std::size_t arrange(const Arrangement& job, int dimensions) {
  return dimensions == 2 ? arrange_in<2>(job) : arrange_in<3>(job);
}

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(pack);
HWY_EXPORT(check);
HWY_EXPORT(bound);
HWY_EXPORT(place);
HWY_EXPORT(record);
HWY_EXPORT(bin);
HWY_EXPORT(arrange);

ElementKernels simd_element_kernels(std::int64_t target) {
  const std::size_t level = table_index(target);
  return {HWY_DISPATCH_TABLE(pack)[level],   HWY_DISPATCH_TABLE(check)[level],
          HWY_DISPATCH_TABLE(bound)[level],  HWY_DISPATCH_TABLE(place)[level],
          HWY_DISPATCH_TABLE(record)[level], HWY_DISPATCH_TABLE(bin)[level],
          HWY_DISPATCH_TABLE(arrange)[level]};
}

}  // namespace abut::kernels
#endif
