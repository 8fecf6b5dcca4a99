#pragma once

#include "exact/elements.hpp"
#include "exact/sphere_predicate.hpp"
#include "kernels/tie_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Decides pairs on the caller's numbers. Adds one to `exact_decisions` when doubles cannot decide.
class ExactDecider {
 public:
  [[nodiscard]] virtual bool within_reach(std::uint32_t first, std::uint32_t second,
                                          std::uint64_t& exact_decisions) const = 0;

  /// The verdicts on all undecided pairs.
  virtual void decide(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const = 0;

  /// The spheres that decide, packed, if vectors decide on them.
  [[nodiscard]] virtual const double* spheres() const noexcept { return nullptr; }

 protected:
  ExactDecider() = default;
  ~ExactDecider() = default;
  ExactDecider(const ExactDecider&) = default;
  ExactDecider& operator=(const ExactDecider&) = default;

  /// Decides undecided pairs one by one, from number `first` on; fetch(element) prefetches what a
  /// later decision needs.
  template <class Fetch>
  void decide_each(kernels::HitBuffer& hits, std::size_t first, std::uint64_t& exact_decisions,
                   Fetch fetch) const {
    constexpr std::size_t ahead = kernels::hits_fetched_ahead;
    const auto fetch_pair = [&](std::size_t k) {
      if (k >= hits.undecided_count) return;
      fetch(hits.element[hits.undecided[k]]);
      fetch(hits.partner[hits.undecided[k]]);
    };
    for (std::size_t k = first; k < first + ahead; ++k) fetch_pair(k);
    for (std::size_t k = first; k < hits.undecided_count; ++k) {
      fetch_pair(k + ahead);
      const std::uint32_t place = hits.undecided[k];
      const bool within = within_reach(hits.element[place], hits.partner[place], exact_decisions);
      hits.verdict[k] = within ? kernels::Verdict::within_reach : kernels::Verdict::apart;
    }
  }
};

template <int Dim>
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final, nothing is derived from it
class OpenDecider final : public ExactDecider {
 public:
  OpenDecider(const exact::Elements<Dim>& originals, double margin, kernels::TieKernels kernels)
      : originals_(originals), margin_(margin), kernels_(kernels) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    return originals_.within_reach(first, second, margin_, exact_decisions);
  }

  void decide(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const override {
    if (originals_.are_boxes()) {
      return decide_each(hits, 0, exact_decisions, [this](std::uint32_t element) {
        __builtin_prefetch(&originals_.boxes[element]);
      });
    }
    const std::size_t treated = decide_in_vectors(hits, exact_decisions);
    decide_each(hits, treated, exact_decisions, [this](std::uint32_t element) {
      __builtin_prefetch(&originals_.spheres[element]);
    });
  }

  [[nodiscard]] const double* spheres() const noexcept override {
    return originals_.are_boxes() ? nullptr : originals_.spheres.data()->center;
  }

 private:
  /// Returns how many of the pairs, from the front.
  std::size_t decide_in_vectors(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const {
    const std::span spheres = originals_.spheres;
    const std::size_t treated =
        kernels_.decide(spheres[0].center, Dim, margin_, hits, exact_decisions);
    for (std::size_t k = 0; k < treated; ++k) {
      if (hits.verdict[k] != kernels::Verdict::open) continue;
      const exact::Sphere<Dim>& a = spheres[hits.element[hits.undecided[k]]];
      const exact::Sphere<Dim>& b = spheres[hits.partner[hits.undecided[k]]];
      hits.verdict[k] = exact::within_reach_exactly(a, b, margin_) ? kernels::Verdict::within_reach
                                                                   : kernels::Verdict::apart;
    }
    return treated;
  }

  exact::Elements<Dim> originals_;
  double margin_;
  kernels::TieKernels kernels_;
};

}  // namespace abut::engine
