#pragma once

#include "kernels/search_job.hpp"
#include "kernels/strided_spheres.hpp"
#include "kernels/tie_kernels.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Decides pairs on the caller's numbers. Adds one to `exact_decisions` when doubles cannot decide.
class ExactDecider {
 public:
  [[nodiscard]] virtual bool within_reach(std::uint32_t first, std::uint32_t second,
                                          std::uint64_t& exact_decisions) const = 0;

  /// The verdicts on all undecided pairs.
  virtual void decide(kernels::HitBuffer& hits, std::uint64_t& exact_decisions) const = 0;

  /// The spheres that decide, if vectors decide on them; otherwise null.
  [[nodiscard]] virtual const kernels::StridedSpheres* spheres() const noexcept { return nullptr; }

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

}  // namespace abut::engine
