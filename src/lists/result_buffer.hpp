#pragma once

#include "base/array.hpp"
#include "base/memory_meter.hpp"

#include <abut/pair_list.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::lists {

/// Sizes a result array and accounts for its bytes while it is filled; afterwards it is the
/// caller's. The first `kept` values stay.
template <class T>
class ResultBuffer {
 public:
  ResultBuffer(std::vector<T, detail::PageAllocator<T>>& array, std::size_t size,
               base::MemoryMeter& memory, std::size_t kept = 0)
      : memory_(memory), bytes_(size * sizeof(T)) {
    memory_.take_for_pairs(bytes_);
    try {
      if (array.capacity() < size) array.resize(kept);
      base::reserve_to_grow(array, size);
      array.resize(size);
    } catch (...) {
      memory_.give_back_pairs(bytes_);
      throw;
    }
  }
  ~ResultBuffer() { memory_.give_back_pairs(bytes_); }

  ResultBuffer(const ResultBuffer&) = delete;
  ResultBuffer& operator=(const ResultBuffer&) = delete;

 private:
  base::MemoryMeter& memory_;
  std::uint64_t bytes_;
};

/// Empties the arrays of a neighbor list before they are filled and, unless keep() is called, again
/// at its end.
template <class Arrays>
class RowBuffers {
 public:
  explicit RowBuffers(const Arrays& arrays) : arrays_(arrays) { clear(); }
  ~RowBuffers() {
    if (!is_kept_) clear();
  }

  RowBuffers(const RowBuffers&) = delete;
  RowBuffers& operator=(const RowBuffers&) = delete;

  void keep() noexcept { is_kept_ = true; }

 private:
  void clear() noexcept {
    arrays_.offsets.clear();
    arrays_.neighbors.clear();
    arrays_.shifts.clear();
  }

  const Arrays& arrays_;
  bool is_kept_ = false;
};

/// Empties the arrays of quantities before they are filled and, unless keep() is called, again at
/// its end.
class GeometryBuffers {
 public:
  explicit GeometryBuffers(PairGeometry& geometry) : geometry_(geometry) { clear(); }
  ~GeometryBuffers() {
    if (!is_kept_) clear();
  }

  GeometryBuffers(const GeometryBuffers&) = delete;
  GeometryBuffers& operator=(const GeometryBuffers&) = delete;

  void keep() noexcept { is_kept_ = true; }

 private:
  void clear() noexcept {
    geometry_.gaps.clear();
    geometry_.normals.clear();
    geometry_.points.clear();
    geometry_.distances.clear();
    geometry_.vectors.clear();
  }

  PairGeometry& geometry_;
  bool is_kept_ = false;
};

/// Sizes the arrays of the quantities that are wanted and accounts for their bytes meanwhile.
class SizedGeometry {
 public:
  SizedGeometry(PairGeometry& geometry, Quantities wanted, std::size_t size,
                base::MemoryMeter& memory)
      : gaps_(geometry.gaps, wanted.has(Quantity::gap) ? size : 0, memory),
        normals_(geometry.normals, wanted.has(Quantity::normal) ? size : 0, memory),
        points_(geometry.points, wanted.has(Quantity::point) ? size : 0, memory),
        distances_(geometry.distances, wanted.has(Quantity::distance) ? size : 0, memory),
        vectors_(geometry.vectors, wanted.has(Quantity::vector) ? size : 0, memory) {}

 private:
  ResultBuffer<double> gaps_;
  ResultBuffer<Vector> normals_;
  ResultBuffer<Vector> points_;
  ResultBuffer<double> distances_;
  ResultBuffer<Vector> vectors_;
};

}  // namespace abut::lists
