#pragma once

#include "kernels/searched_elements.hpp"

#include <algorithm>
#include <cstdint>

namespace abut::kernels {

/// What single precision tells of two elements.
enum class ProbeAnswer { none, undecided, sure };

/// An element beside its candidates: equal spheres, or spheres.
template <int Dim, ElementShape Shape>
class ScalarProbe {
 public:
  ScalarProbe(const SearchedElements& elements, const SearchJob& job, std::uint32_t p)
      : elements_(elements), number_(elements.number[p]) {
    for (int axis = 0; axis < Dim; ++axis) center_[axis] = elements.center[axis][p];
    set_reach(job, equal ? elements.common_radius : elements.size[0][p], job.slack);
  }

  ScalarProbe(const SearchedElements& elements, const SearchJob& job, const CoarseElement& coarse)
      : elements_(elements), number_(coarse.number) {
    std::copy_n(coarse.center, Dim, center_);
    set_reach(job, coarse.size[0], coarse.slack);
  }

  [[nodiscard]] std::uint32_t number() const { return number_; }

  [[nodiscard]] ProbeAnswer test(std::uint32_t q) const {
    float difference = center_[0] - elements_.center[0][q];
    float distance_squared = difference * difference;
    for (int axis = 1; axis < Dim; ++axis) {
      difference = center_[axis] - elements_.center[axis][q];
      distance_squared += difference * difference;
    }
    const float radius = equal ? 0.0f : elements_.size[0][q];
    const float farthest = outer_ + radius;
    if (!(distance_squared <= farthest * farthest)) return ProbeAnswer::none;
    const float nearest = std::max(inner_ + radius, 0.0f);
    return distance_squared < nearest * nearest ? ProbeAnswer::sure : ProbeAnswer::undecided;
  }

 private:
  static constexpr bool equal = Shape == ElementShape::equal_spheres;

  void set_reach(const SearchJob& job, float radius, float slack) {
    const float reach = radius + job.margin + (equal ? elements_.common_radius : 0.0f);
    outer_ = reach + slack;
    inner_ = reach - slack;
  }

  const SearchedElements& elements_;
  float center_[Dim];
  float outer_;
  float inner_;
  std::uint32_t number_;
};

/// Tests two boxes: on each axis neither may begin behind the other's end.
template <int Dim>
class ScalarProbe<Dim, ElementShape::boxes> {
 public:
  ScalarProbe(const SearchedElements& elements, const SearchJob& job, std::uint32_t p)
      : elements_(elements),
        outer_(job.margin + job.slack),
        inner_(job.margin - job.slack),
        number_(elements.number[p]) {
    for (int axis = 0; axis < Dim; ++axis) {
      lower_[axis] = elements.center[axis][p];
      width_[axis] = elements.size[axis][p];
    }
  }

  ScalarProbe(const SearchedElements& elements, const SearchJob& job, const CoarseElement& coarse)
      : elements_(elements),
        outer_(job.margin + coarse.slack),
        inner_(job.margin - coarse.slack),
        number_(coarse.number) {
    std::copy_n(coarse.center, Dim, lower_);
    std::copy_n(coarse.size, Dim, width_);
  }

  [[nodiscard]] std::uint32_t number() const { return number_; }

  [[nodiscard]] ProbeAnswer test(std::uint32_t q) const {
    bool sure = true;
    for (int axis = 0; axis < Dim; ++axis) {
      const float behind = lower_[axis] - elements_.center[axis][q];
      const float width = elements_.size[axis][q];
      if (!(behind <= width + outer_ && -behind <= width_[axis] + outer_)) return ProbeAnswer::none;
      sure = sure && behind < width + inner_ && -behind < width_[axis] + inner_;
    }
    return sure ? ProbeAnswer::sure : ProbeAnswer::undecided;
  }

 private:
  const SearchedElements& elements_;
  float lower_[Dim];
  float width_[Dim];
  float outer_;
  float inner_;
  std::uint32_t number_;
};

/// Notes a pair that is not certainly apart.
inline void push_hit(SearchJob& job, std::uint32_t element, std::uint32_t partner,
                     ProbeAnswer answer) {
  HitBuffer& to = *job.hits;
  if (to.found == HitBuffer::size) job.take(job);
  if (answer == ProbeAnswer::undecided) {
    to.undecided[to.undecided_count++] = static_cast<std::uint32_t>(to.found);
  }
  to.element[to.found] = element;
  to.partner[to.found++] = partner;
}

}  // namespace abut::kernels
