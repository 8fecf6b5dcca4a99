#pragma once

#include "engine/arbiter.hpp"
#include "exact/elements.hpp"
#include "exact/lattice.hpp"
#include "periodic/images.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut::engine {

/// Numbers from the count of natives on are those of ghosts. Two ghosts are no pair.
template <int Dim>
class PeriodicArbiter final : public Arbiter {
 public:
  PeriodicArbiter(const base::Elements<Dim>& originals, const base::Lattice& lattice,
                  const Images<Dim>& images, double margin)
      : originals_(originals), lattice_(lattice), images_(images), margin_(margin) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    const std::size_t natives = originals_.size();
    if (second < first) std::swap(first, second);
    if (first >= natives) return false;
    if (second < natives) {
      return within_reach(first, second, images_.shift_between(first, second), exact_decisions);
    }
    const Ghost& ghost = images_.ghosts()[second - natives];
    return within_reach(first, ghost.element, images_.shift_between(first, ghost), exact_decisions);
  }

  void decide(kernels::Findings& findings, std::uint64_t& exact_decisions) const override {
    decide_each(findings, 0, exact_decisions, [this](std::uint32_t element) {
      if (element >= originals_.size()) return;
      if (originals_.are_boxes()) {
        __builtin_prefetch(&originals_.boxes[element]);
      } else {
        __builtin_prefetch(&originals_.spheres[element]);
      }
    });
  }

 private:
  [[nodiscard]] bool within_reach(std::uint32_t i, std::uint32_t j, const base::ImageShift& shift,
                                  std::uint64_t& exact_decisions) const {
    return originals_.within_reach(i, j, shift, lattice_, margin_, exact_decisions);
  }

  base::Elements<Dim> originals_;
  const base::Lattice& lattice_;
  const Images<Dim>& images_;
  double margin_;
};

}  // namespace abut::engine
