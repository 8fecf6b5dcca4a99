#pragma once

#include "base/progress_reporter.hpp"
#include "exact/box.hpp"

#include <abut/element_view.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::walls {

/// All boxes of a view by a few: each around a run of them. Boxes of a mesh come near each other
/// one after the other, as a rule, so that the runs leave out most of the space between walls.
template <int Dim>
class BoxCover {
 public:
  /// Boxes that are none make a cover that is none.
  BoxCover(const ElementView& boxes, std::size_t workers, base::WorkCounter& work);

  /// From now on all boxes meet on that axis.
  void extend(int axis) noexcept;

  /// Whether the box meets one of the cover, as it does if it meets one that is covered.
  [[nodiscard]] bool meets(const exact::Box<Dim>& box) const noexcept {
    std::uint64_t exact_decisions = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      if (exact::within_reach(around_[k], box, 0.0, exact_decisions)) return true;
    }
    return false;
  }

  /// Boxes that a question goes through.
  [[nodiscard]] std::size_t size() const noexcept { return count_; }

 private:
  static constexpr std::size_t most = 32;

  std::array<exact::Box<Dim>, most> around_;
  std::size_t count_;
};

}  // namespace abut::walls
