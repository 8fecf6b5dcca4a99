#pragma once

#include "engine/deciders/exact_decider.hpp"
#include "exact/sphere_predicate.hpp"
#include "kernels/strided_spheres.hpp"
#include "kernels/tie_kernels.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Decides on spheres, wherever their numbers lie.
template <int Dim>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final, nothing is derived from it
class SphereDecider final : public ExactDecider {
 public:
  SphereDecider(const kernels::StridedSpheres& spheres, double margin, kernels::TieKernels kernels)
      : spheres_(spheres), margin_(margin), kernels_(kernels) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    return exact::within_reach(sphere(first), sphere(second), margin_, exact_decisions);
  }

  void decide(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const override {
    const std::size_t treated = kernels_.decide(spheres_, Dim, margin_, hits, exact_decisions);
    for (std::size_t k = 0; k < treated; ++k) {
      if (hits.verdict[k] != kernels::Verdict::open) continue;
      const exact::Sphere<Dim> a = sphere(hits.element[hits.undecided[k]]);
      const exact::Sphere<Dim> b = sphere(hits.partner[hits.undecided[k]]);
      hits.verdict[k] = exact::within_reach_exactly(a, b, margin_) ? kernels::Verdict::within_reach
                                                                   : kernels::Verdict::apart;
    }
    decide_each(hits, treated, exact_decisions,
                [this](std::uint32_t element) { kernels::fetch<Dim>(spheres_, element); });
  }

  [[nodiscard]] const kernels::StridedSpheres* spheres() const noexcept override {
    return &spheres_;
  }

 private:
  [[nodiscard]] exact::Sphere<Dim> sphere(std::uint32_t number) const noexcept {
    return kernels::sphere_at<Dim>(spheres_, number);
  }

  kernels::StridedSpheres spheres_;
  double margin_;
  kernels::TieKernels kernels_;
};

}  // namespace abut::engine
