#pragma once

#include "engine/deciders/exact_decider.hpp"
#include "engine/deciders/sphere_decider.hpp"
#include "exact/elements.hpp"
#include "exact/lattice.hpp"
#include "exact/periodic_predicate.hpp"
#include "kernels/search_job.hpp"
#include "kernels/strided_spheres.hpp"
#include "kernels/tie_kernels.hpp"
#include "lattice/image_decider.hpp"
#include "periodic/images.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut::periodic {

/// What becomes of pairs of which an element was moved: they are decided, or kept for the one who
/// decides all that is found of them (DecidingSink).
enum class MovedPairs : std::uint8_t { decided, kept };

/// Numbers from the count of locals on are those of ghosts. Two ghosts are no pair. Where no sphere
/// was moved, pairs of two locals are decided as in open space.
template <int Dim>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final, nothing is derived from it
class PeriodicDecider final : public engine::ExactDecider {
 public:
  /// The originals are the elements as given, their spheres besides where these lie. Packed ones
  /// may be missing where all shifts fit.
  PeriodicDecider(const exact::Elements<Dim>& originals, const kernels::StridedSpheres& spheres,
                  const exact::Lattice& lattice, const Images<Dim>& images, double margin,
                  kernels::TieKernels kernels, MovedPairs moved = MovedPairs::decided)
      : originals_(originals),
        spheres_(spheres),
        lattice_(lattice),
        images_(images),
        margin_(margin),
        moved_(moved),
        of_locals_(spheres, margin, kernels),
        by_numbers_(originals, lattice, images.reduced_lattice(), images.given_unit(), margin) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    const std::size_t locals = spheres_.size;
    if (second < first) std::swap(first, second);
    if (first >= locals) return false;
    if (moved_ == MovedPairs::kept && !images_.are_as_given(first, second)) return true;
    if (second < locals) return within_reach(first, {second, {}}, exact_decisions);
    return within_reach(first, images_.ghosts()[second - locals], exact_decisions);
  }

  void decide(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const override {
    if (!originals_.are_boxes() && !images_.moved_any()) {
      return decide_unmoved(hits, exact_decisions);
    }
    decide_each(hits, 0, exact_decisions, [this](std::uint32_t element) {
      if (element >= spheres_.size) return;
      if (originals_.are_boxes()) {
        __builtin_prefetch(&originals_.boxes[element]);
      } else {
        kernels::fetch<Dim>(spheres_, element);
      }
    });
  }

 private:
  void decide_unmoved(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const {
    kernels::HitBuffer of_locals;
    std::array<std::uint32_t, kernels::HitBuffer::size> number_among_all;
    for (std::uint32_t k = 0; k < hits.undecided_count; ++k) {
      const std::uint32_t element = hits.element[hits.undecided[k]];
      const std::uint32_t partner = hits.partner[hits.undecided[k]];
      if (std::max(element, partner) >= spheres_.size) {
        const bool within = within_reach(element, partner, exact_decisions);
        hits.verdict[k] = within ? kernels::Verdict::within_reach : kernels::Verdict::apart;
        continue;
      }
      const auto own = static_cast<std::uint32_t>(of_locals.undecided_count++);
      of_locals.element[own] = element;
      of_locals.partner[own] = partner;
      of_locals.undecided[own] = own;
      number_among_all[own] = k;
    }
    of_locals_.decide(of_locals, exact_decisions);
    for (std::size_t own = 0; own < of_locals.undecided_count; ++own) {
      hits.verdict[number_among_all[own]] = of_locals.verdict[own];
    }
  }

  [[nodiscard]] bool within_reach(std::uint32_t i, const Ghost& image,
                                  std::uint64_t& exact_decisions) const {
    const auto& [j, cells] = image;
    if (!images_.shifts_always_fit()) {
      const lattice::ImageNumbers numbers = images_.numbers_between(i, j, cells);
      return by_numbers_.shift_within_reach(i, j, numbers, exact_decisions).has_value();
    }
    const ImageShift shift = images_.shift_between(i, image);
    if (originals_.are_boxes()) {
      return originals_.within_reach(i, j, shift, lattice_, margin_, exact_decisions);
    }
    return exact::within_reach(kernels::sphere_at<Dim>(spheres_, i),
                               kernels::sphere_at<Dim>(spheres_, j), shift, lattice_, margin_,
                               exact_decisions);
  }

  exact::Elements<Dim> originals_;
  kernels::StridedSpheres spheres_;
  const exact::Lattice& lattice_;
  const Images<Dim>& images_;
  double margin_;
  MovedPairs moved_;
  engine::SphereDecider<Dim> of_locals_;
  lattice::ImageDecider<Dim> by_numbers_;
};

}  // namespace abut::periodic
