#pragma once

#include "engine/deciders/exact_decider.hpp"
#include "exact/box.hpp"
#include "kernels/strided_boxes.hpp"

#include <cstdint>

namespace abut::engine {

/// Decides on boxes, wherever their corners lie, one pair after the other.
template <int Dim>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final, nothing is derived from it
class BoxDecider final : public ExactDecider {
 public:
  BoxDecider(const kernels::StridedBoxes& boxes, double margin) : boxes_(boxes), margin_(margin) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    return exact::within_reach(box(first), box(second), margin_, exact_decisions);
  }

  void decide(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const override {
    decide_each(hits, 0, exact_decisions,
                [this](std::uint32_t element) { kernels::fetch<Dim>(boxes_, element); });
  }

 private:
  [[nodiscard]] exact::Box<Dim> box(std::uint32_t number) const noexcept {
    return kernels::box_at<Dim>(boxes_, number);
  }

  kernels::StridedBoxes boxes_;
  double margin_;
};

}  // namespace abut::engine
