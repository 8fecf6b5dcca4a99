#include "walls/box_cover.hpp"

#include "base/asking_workers.hpp"
#include "elements/gathered_elements.hpp"

#include <algorithm>
#include <limits>

namespace abut::walls {

template <int Dim>
BoxCover<Dim>::BoxCover(const ElementView& boxes, std::size_t workers, base::WorkCounter& work)
    : count_(std::min(most, boxes.size())) {
  const auto cover_run = [&](std::size_t, std::size_t run, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(run, count_, boxes.size());
    exact::Box<Dim> around = elements::box_at<Dim>(boxes, first);
    for (std::size_t k = first + 1; k < last; ++k) {
      its_work.did(1);
      const exact::Box<Dim> box = elements::box_at<Dim>(boxes, k);
      for (int axis = 0; axis < Dim; ++axis) {
        around.lower[axis] = std::min(around.lower[axis], box.lower[axis]);
        around.upper[axis] = std::max(around.upper[axis], box.upper[axis]);
      }
    }
    around_[run] = around;
  };
  base::for_each_index(workers, count_, work, cover_run);
}

template <int Dim>
void BoxCover<Dim>::extend(int axis) noexcept {
  for (std::size_t k = 0; k < count_; ++k) {
    around_[k].lower[axis] = -std::numeric_limits<double>::max();
    around_[k].upper[axis] = std::numeric_limits<double>::max();
  }
}

template class BoxCover<2>;
template class BoxCover<3>;

}  // namespace abut::walls
