#pragma once

#include "device/bodies/periodic/packed_cells.hpp"
#include "device/executor.hpp"
#include "lattice/wrapper.hpp"

#include <cstdint>

namespace abut::device {

/// Memory for numbers of cells along the sides: a word for each entry if all fit, else three.
template <class Word, class E>
class CellBuffer {
 public:
  CellBuffer() = default;
  CellBuffer(E& executor, std::uint64_t size, const PackedLayout& packing) : packing_(packing) {
    if (packing.bits() <= static_cast<int>(8 * sizeof(Word))) {
      words_ = Buffer<Word, E>(executor, size);
    } else {
      wide_ = Buffer<lattice::CellsMoved, E>(executor, size);
    }
  }

  [[nodiscard]] PackedCells<Word> cells() const noexcept {
    return {words_.data(), wide_.data(), packing_};
  }

 private:
  Buffer<Word, E> words_;
  Buffer<lattice::CellsMoved, E> wide_;
  PackedLayout packing_;
};

}  // namespace abut::device
