// The places of elements in a plane, in vectors, included like simd_plane_tester-inl.hpp.

/// Doubles, and as many numbers of half the length.
using CenterTag = hn::ScalableTag<double>;
using PositionTag = hn::Rebind<float, CenterTag>;
constexpr CenterTag centers{};
constexpr PositionTag positions_of_centers{};

template <int Dim>
HWY_INLINE void load_packed(const double* records, hn::Vec<CenterTag>* center) {
  hn::Vec<CenterTag> radius;
  if constexpr (Dim == 2) {
    hn::LoadInterleaved3(centers, records, center[0], center[1], radius);
  } else {
    hn::LoadInterleaved4(centers, records, center[0], center[1], center[2], radius);
  }
}

template <int Dim>
std::size_t locate_in(const double* records, std::size_t count, const PlaneMap& map,
                      float* const* positions) {
  const auto unit = hn::Set(centers, map.unit);
  std::size_t k = 0;
  for (; k + hn::Lanes(centers) <= count; k += hn::Lanes(centers)) {
    hn::Vec<CenterTag> center[Dim];
    load_packed<Dim>(records + k * (Dim + 1), center);
    for (int axis = 0; axis < Dim; ++axis) {
      const auto from_lower = hn::Sub(center[axis], hn::Set(centers, map.lower[axis]));
      hn::StoreU(hn::DemoteTo(positions_of_centers, hn::Mul(from_lower, unit)),
                 positions_of_centers, positions[axis] + k);
    }
  }
  return k;
}

std::size_t locate(const double* records, std::size_t count, int dimensions, const PlaneMap& map,
                   float* const* positions) {
  return dimensions == 2 ? locate_in<2>(records, count, map, positions)
                         : locate_in<3>(records, count, map, positions);
}

std::size_t find_columns(const float* along, const float* across, std::size_t count,
                         const PlaneMap& map, std::uint32_t* columns) {
  constexpr hn::RebindToUnsigned<WideTag> wide_numbers{};
  const hn::RebindToSigned<WideTag> integers;
  const auto place = [&](const float* position, int k) HWY_ATTR {
    const auto at =
        hn::Mul(hn::LoadU(wide_floats, position), hn::Set(wide_floats, map.per_unit[k]));
    const auto whole = hn::ConvertTo(integers, hn::Min(at, hn::Set(wide_floats, map.last[k])));
    return hn::BitCast(wide_numbers, whole);
  };
  const auto first = hn::Set(wide_numbers, map.first_column);
  const auto length = hn::Set(wide_numbers, map.row_length);
  std::size_t k = 0;
  for (; k + wide_lanes <= count; k += wide_lanes) {
    const auto row = hn::Mul(place(across + k, 1), length);
    hn::StoreU(hn::Add(hn::Add(row, first), place(along + k, 0)), wide_numbers, columns + k);
  }
  return k;
}
