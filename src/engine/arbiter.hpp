#pragma once

#include "exact/elements.hpp"
#include "exact/sphere_predicate.hpp"
#include "kernels/tie_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Decides pairs on the caller's numbers. Adds one to `exact_decisions` when doubles cannot decide.
class Arbiter {
 public:
  [[nodiscard]] virtual bool within_reach(std::uint32_t first, std::uint32_t second,
                                          std::uint64_t& exact_decisions) const = 0;

  /// The verdicts on all doubtful pairs.
  virtual void decide(kernels::Findings& findings, std::uint64_t& exact_decisions) const = 0;

 protected:
  Arbiter() = default;
  ~Arbiter() = default;
  Arbiter(const Arbiter&) = default;
  Arbiter& operator=(const Arbiter&) = default;

  /// From the `first`-th doubtful pair on, one by one; fetch(element) asks for what a decision will
  /// need, ahead of it.
  template <class Fetch>
  void decide_each(kernels::Findings& findings, std::size_t first, std::uint64_t& exact_decisions,
                   Fetch fetch) const {
    constexpr std::size_t fetched_ahead = 8;  // enough to hide the way to memory
    const auto fetch_pair = [&](std::size_t k) {
      if (k >= findings.doubts) return;
      fetch(findings.element[findings.doubtful[k]]);
      fetch(findings.partner[findings.doubtful[k]]);
    };
    for (std::size_t k = first; k < first + fetched_ahead; ++k) fetch_pair(k);
    for (std::size_t k = first; k < findings.doubts; ++k) {
      fetch_pair(k + fetched_ahead);
      const std::uint32_t place = findings.doubtful[k];
      const bool within =
          within_reach(findings.element[place], findings.partner[place], exact_decisions);
      findings.verdict[k] = within ? kernels::Verdict::within_reach : kernels::Verdict::apart;
    }
  }
};

template <int Dim>
class OpenArbiter final : public Arbiter {
 public:
  OpenArbiter(const base::Elements<Dim>& originals, double margin, kernels::TieKernels kernels)
      : originals_(originals), margin_(margin), kernels_(kernels) {}

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    return originals_.within_reach(first, second, margin_, exact_decisions);
  }

  void decide(kernels::Findings& findings, std::uint64_t& exact_decisions) const override {
    if (originals_.are_boxes()) {
      return decide_each(findings, 0, exact_decisions, [this](std::uint32_t element) {
        __builtin_prefetch(&originals_.boxes[element]);
      });
    }
    const std::size_t treated = decide_in_vectors(findings, exact_decisions);
    decide_each(findings, treated, exact_decisions, [this](std::uint32_t element) {
      __builtin_prefetch(&originals_.spheres[element]);
    });
  }

 private:
  /// Returns how many of the pairs, from the front.
  std::size_t decide_in_vectors(kernels::Findings& findings, std::uint64_t& exact_decisions) const {
    const std::span spheres = originals_.spheres;
    const std::size_t treated =
        kernels_.decide(spheres[0].center, Dim, margin_, findings, exact_decisions);
    for (std::size_t k = 0; k < treated; ++k) {
      if (findings.verdict[k] != kernels::Verdict::open) continue;
      const base::Sphere<Dim>& a = spheres[findings.element[findings.doubtful[k]]];
      const base::Sphere<Dim>& b = spheres[findings.partner[findings.doubtful[k]]];
      findings.verdict[k] = base::within_reach_exactly(a, b, margin_)
                                ? kernels::Verdict::within_reach
                                : kernels::Verdict::apart;
    }
    return treated;
  }

  base::Elements<Dim> originals_;
  double margin_;
  kernels::TieKernels kernels_;
};

}  // namespace abut::engine
