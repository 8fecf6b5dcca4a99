// Spheres read in vectors from the places where their numbers lie, included once for each
// instruction set into the namespace of a file of kernels.

using DoubleTag = hn::ScalableTag<double>;
using Doubles = hn::Vec<DoubleTag>;
constexpr DoubleTag doubles{};

/// Centers in a column of contiguous numbers for each axis.
template <int Dim>
class CenterColumns {
 public:
  HWY_INLINE explicit CenterColumns(const kernels::StridedSpheres& spheres) : spheres_(spheres) {}

  [[nodiscard]] static bool fit(const kernels::StridedSpheres& spheres) {
    return std::all_of(spheres.stride, spheres.stride + Dim,
                       [](std::ptrdiff_t stride) { return stride == 1; });
  }

  HWY_INLINE void load(std::size_t k, Doubles* center) const {
    for (int axis = 0; axis < Dim; ++axis) {
      center[axis] = hn::LoadU(doubles, spheres_.begin[axis] + k);
    }
  }

 private:
  const kernels::StridedSpheres& spheres_;
};

/// Centers in records of so many numbers, contiguous and one behind the other.
template <int Dim, int Length>
class CenterRecords {
 public:
  HWY_INLINE explicit CenterRecords(const kernels::StridedSpheres& spheres)
      : records_(spheres.begin[0]) {}

  [[nodiscard]] static bool fit(const kernels::StridedSpheres& spheres) {
    for (int axis = 0; axis < Dim; ++axis) {
      if (spheres.stride[axis] != Length) return false;
      if (spheres.begin[axis] != spheres.begin[0] + axis) return false;
    }
    return true;
  }

  HWY_INLINE void load(std::size_t k, Doubles* center) const {
    Doubles other;
    if constexpr (Length == 2) {
      hn::LoadInterleaved2(doubles, records_ + k * 2, center[0], center[1]);
    } else if constexpr (Dim == 2) {
      hn::LoadInterleaved3(doubles, records_ + k * 3, center[0], center[1], other);
    } else if constexpr (Length == 3) {
      hn::LoadInterleaved3(doubles, records_ + k * 3, center[0], center[1], center[2]);
    } else {
      hn::LoadInterleaved4(doubles, records_ + k * 4, center[0], center[1], center[2], other);
    }
  }

 private:
  const double* records_;
};

/// Radii that all spheres share, or in a column of contiguous numbers.
class RadiusReader {
 public:
  HWY_INLINE explicit RadiusReader(const kernels::StridedSpheres& spheres)
      : begin_(spheres.begin[radii]), is_common_(spheres.stride[radii] == 0) {}

  [[nodiscard]] static bool fits(const kernels::StridedSpheres& spheres) {
    return spheres.stride[radii] == 0 || spheres.stride[radii] == 1;
  }

  [[nodiscard]] HWY_INLINE Doubles load(std::size_t k) const {
    return is_common_ ? hn::Set(doubles, *begin_) : hn::LoadU(doubles, begin_ + k);
  }

 private:
  static constexpr int radii = kernels::StridedSpheres::radii;

  const double* begin_;
  bool is_common_;
};

/// Centers and radii in arrays of their own.
template <int Dim, class Centers>
class SpheresInColumns {
 public:
  HWY_INLINE explicit SpheresInColumns(const kernels::StridedSpheres& spheres)
      : centers_(spheres), radii_(spheres) {}

  [[nodiscard]] static bool fit(const kernels::StridedSpheres& spheres) {
    return Centers::fit(spheres) && RadiusReader::fits(spheres);
  }

  HWY_INLINE void load(std::size_t k, Doubles* center, Doubles& radius) const {
    centers_.load(k, center);
    radius = radii_.load(k);
  }
  HWY_INLINE void load_center(std::size_t k, Doubles* center) const { centers_.load(k, center); }

 private:
  Centers centers_;
  RadiusReader radii_;
};

/// Spheres that are packed, one record each.
template <int Dim>
class PackedSpheres {
 public:
  HWY_INLINE explicit PackedSpheres(const kernels::StridedSpheres& spheres)
      : records_(spheres.begin[0]) {}

  [[nodiscard]] static bool fit(const kernels::StridedSpheres& spheres) {
    return kernels::packed_records<Dim>(spheres) != nullptr;
  }

  HWY_INLINE void load(std::size_t k, Doubles* center, Doubles& radius) const {
    const double* const record = records_ + k * (Dim + 1);
    if constexpr (Dim == 2) {
      hn::LoadInterleaved3(doubles, record, center[0], center[1], radius);
    } else {
      hn::LoadInterleaved4(doubles, record, center[0], center[1], center[2], radius);
    }
  }
  HWY_INLINE void load_center(std::size_t k, Doubles* center) const {
    Doubles radius;
    load(k, center, radius);
  }

 private:
  const double* records_;
};

/// Returns body(dimensions), the number of dimensions as a constant.
template <class Body>
std::size_t with_dimensions(int dimensions, const Body& body) {
  return dimensions == 2 ? body(std::integral_constant<int, 2>())
                         : body(std::integral_constant<int, 3>());
}

/// Returns body(centers) for the reader of such centers in vectors, wherever their radii lie, or 0
/// where there is none.
template <int Dim, class Body>
std::size_t with_centers(const kernels::StridedSpheres& spheres, const Body& body) {
  using Points = CenterRecords<Dim, Dim>;
  using Packed = CenterRecords<Dim, Dim + 1>;
  if (CenterColumns<Dim>::fit(spheres)) return body(CenterColumns<Dim>(spheres));
  if (Points::fit(spheres)) return body(Points(spheres));
  if (Packed::fit(spheres)) return body(Packed(spheres));
  return 0;
}

/// Returns body(loader) for the loader that reads such spheres in vectors, or 0 where none does.
template <int Dim, class Body>
std::size_t with_loader(const kernels::StridedSpheres& spheres, const Body& body) {
  using InColumns = SpheresInColumns<Dim, CenterColumns<Dim>>;
  using InPoints = SpheresInColumns<Dim, CenterRecords<Dim, Dim>>;
  if (PackedSpheres<Dim>::fit(spheres)) return body(PackedSpheres<Dim>(spheres));
  if (InPoints::fit(spheres)) return body(InPoints(spheres));
  if (InColumns::fit(spheres)) return body(InColumns(spheres));
  return 0;
}
