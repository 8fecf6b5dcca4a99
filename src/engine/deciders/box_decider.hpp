#pragma once

#include "engine/deciders/exact_decider.hpp"
#include "exact/box.hpp"

#include <cstdint>
#include <span>

namespace abut::engine {

/// Decides on boxes, one pair after the other.
template <int Dim>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final, nothing is derived from it
class BoxDecider final : public ExactDecider {
 public:
  BoxDecider(std::span<const exact::Box<Dim>> boxes, double margin)
      : boxes_(boxes), margin_(margin) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    return exact::within_reach(boxes_[first], boxes_[second], margin_, exact_decisions);
  }

  void decide(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const override {
    decide_each(hits, 0, exact_decisions,
                [this](std::uint32_t element) { __builtin_prefetch(&boxes_[element]); });
  }

 private:
  std::span<const exact::Box<Dim>> boxes_;
  double margin_;
};

}  // namespace abut::engine
