#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"

#include <abut/element_view.hpp>
#include <abut/simd.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace abut::skin {

/// Remembers where elements were, the *anchor*, and tells whether any two of them may have come
/// closer than then by more than a length. It reads the caller's arrays as they are; in a periodic
/// domain an element that is brought back into the cell has moved by a lattice vector.
class PositionTracker {
 public:
  explicit PositionTracker(base::MemoryMeter& memory);

  /// The anchor is where the elements are now.
  void anchor(const ElementView& elements, base::WorkCounter& work);

  /// Forgets the anchor.
  void release() noexcept { dimensions_ = 0; }

  /// True unless there is an anchor of as many elements, and no two of them have come closer by
  /// more than `allowed`, in real arithmetic.
  [[nodiscard]] bool may_have_approached(const ElementView& elements, double allowed, Simd simd,
                                         std::size_t workers, base::WorkCounter& work) const;

 private:
  std::array<base::Array<double>, 3> then_;
  std::size_t size_ = 0;
  int dimensions_ = 0;  ///< 0: there is no anchor
};

}  // namespace abut::skin
