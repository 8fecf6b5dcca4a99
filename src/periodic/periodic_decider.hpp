#pragma once

#include "engine/deciders/exact_decider.hpp"
#include "exact/elements.hpp"
#include "exact/lattice.hpp"
#include "lattice/image_decider.hpp"
#include "periodic/images.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut::periodic {

/// Numbers from the count of locals on are those of ghosts. Two ghosts are no pair.
template <int Dim>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final, nothing is derived from it
class PeriodicDecider final : public engine::ExactDecider {
 public:
  PeriodicDecider(const exact::Elements<Dim>& originals, const exact::Lattice& lattice,
                  const Images<Dim>& images, double margin)
      : originals_(originals),
        lattice_(lattice),
        images_(images),
        margin_(margin),
        by_numbers_(originals, lattice, images.reduced_lattice(), images.given_unit(), margin) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    const std::size_t locals = originals_.size();
    if (second < first) std::swap(first, second);
    if (first >= locals) return false;
    if (second < locals) return within_reach(first, {second, {}}, exact_decisions);
    return within_reach(first, images_.ghosts()[second - locals], exact_decisions);
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
  [[nodiscard]] bool within_reach(std::uint32_t i, const Ghost& image,
                                  std::uint64_t& exact_decisions) const {
    const auto& [j, cells] = image;
    if (images_.shifts_always_fit()) {
      return originals_.within_reach(i, j, images_.shift_between(i, image), lattice_, margin_,
                                     exact_decisions);
    }
    const lattice::ImageNumbers numbers = images_.numbers_between(i, j, cells);
    return by_numbers_.shift_within_reach(i, j, numbers, exact_decisions).has_value();
  }

  exact::Elements<Dim> originals_;
  const exact::Lattice& lattice_;
  const Images<Dim>& images_;
  double margin_;
  lattice::ImageDecider<Dim> by_numbers_;
};

}  // namespace abut::periodic
