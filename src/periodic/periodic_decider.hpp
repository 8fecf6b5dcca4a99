#pragma once

#include "engine/exact_decider.hpp"
#include "exact/elements.hpp"
#include "exact/lattice.hpp"
#include "periodic/images.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut::periodic {

/// Numbers from the count of locals on are those of ghosts. Two ghosts are no pair.
template <int Dim>
class PeriodicDecider final : public engine::ExactDecider {
 public:
  PeriodicDecider(const exact::Elements<Dim>& originals, const exact::Lattice& lattice,
                  const Images<Dim>& images, double margin)
      : originals_(originals), lattice_(lattice), images_(images), margin_(margin) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    const std::size_t locals = originals_.size();
    if (second < first) std::swap(first, second);
    if (first >= locals) return false;
    if (second < locals) {
      return within_reach(first, second, images_.shift_between(first, second), exact_decisions);
    }
    const Ghost& ghost = images_.ghosts()[second - locals];
    return within_reach(first, ghost.element, images_.shift_between(first, ghost), exact_decisions);
  }

  void decide(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const override {
    decide_each(hits, 0, exact_decisions, [this](std::uint32_t element) {
      if (element >= originals_.size()) return;
      if (originals_.are_boxes()) {
        __builtin_prefetch(&originals_.boxes[element]);
      } else {
        __builtin_prefetch(&originals_.spheres[element]);
      }
    });
  }

 private:
  [[nodiscard]] bool within_reach(std::uint32_t i, std::uint32_t j, const ImageShift& shift,
                                  std::uint64_t& exact_decisions) const {
    return originals_.within_reach(i, j, shift, lattice_, margin_, exact_decisions);
  }

  exact::Elements<Dim> originals_;
  const exact::Lattice& lattice_;
  const Images<Dim>& images_;
  double margin_;
};

}  // namespace abut::periodic
