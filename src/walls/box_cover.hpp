#pragma once

#include "base/progress_reporter.hpp"
#include "exact/box.hpp"

#include <abut/element_view.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::walls {

/// A few large boxes that cover all boxes of a view, each a run of consecutive ones. Consecutive
/// boxes of a mesh mostly lie near each other, so the cover leaves out most of the space between
/// walls.
template <int Dim>
class BoxCover {
 public:
  /// Invalid boxes make an invalid cover, which the search that follows refuses.
  BoxCover(const ElementView& boxes, std::size_t workers, base::WorkCounter& work);

  /// Makes the boxes of the cover unbounded along an axis.
  void extend(int axis) noexcept;

  /// True if the box meets the cover; it does if it meets a box that is covered.
  [[nodiscard]] bool meets(const exact::Box<Dim>& box) const noexcept {
    std::uint64_t exact_decisions = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      if (exact::within_reach(around_[k], box, 0.0, exact_decisions)) return true;
    }
    return false;
  }

  /// Number of boxes in the cover.
  [[nodiscard]] std::size_t size() const noexcept { return count_; }

 private:
  static constexpr std::size_t most = 32;

  std::array<exact::Box<Dim>, most> around_;
  std::size_t count_;
};

}  // namespace abut::walls
