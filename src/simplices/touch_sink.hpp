#pragma once

#include "base/progress_reporter.hpp"
#include "elements/lattice_of.hpp"
#include "exact/lattice.hpp"
#include "exact/simplices/touch.hpp"
#include "lists/filtering_sink.hpp"
#include "simplices/gathered_simplices.hpp"
#include "simplices/simplex_search.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/simplex_contacts.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace abut::simplices {

/// Hands on the pairs of simplices that touch, of pairs whose boxes do. Decided by the workers that
/// find the pairs.
template <int Dim>
class TouchSink final : public lists::FilteringSink {
 public:
  /// All must live until the last pairs are committed.
  TouchSink(const GatheredSimplices<Dim>& first, const GatheredSimplices<Dim>& second,
            const SimplexRequest& request, base::ProgressReporter& progress, base::PairSink& next)
      : first_(first),
        second_(second),
        shared_(request.shared),
        lattice_(elements::lattice_of(request.domain)),
        progress_(progress) {
    pass_to(next);
  }

  [[nodiscard]] std::uint64_t tests() const noexcept { return tests_; }
  /// Number of pairs that the filters left open.
  [[nodiscard]] std::uint64_t exact_decisions() const noexcept { return exact_decisions_; }

 private:
  /// Costs of a decision, in steps through an array: by the filters, and of a sign beyond them.
  static constexpr std::uint64_t steps_of_decision = 64;
  static constexpr std::uint64_t steps_of_sign = 512;

  std::size_t keep(const lists::PairBatch& batch, std::size_t worker) const override {
    base::WorkCounter work(progress_, worker);
    std::uint64_t tests = 0;
    std::uint64_t open = 0;
    const auto decide = [&](const ContactPair& pair, const ImageShift& shift) {
      // An image of a vertex is another vertex.
      if (shared_ == SharedVertices::excluded && shift == ImageShift{} && share_vertex(pair)) {
        return false;
      }
      ++tests;
      std::uint64_t signs = 0;
      const bool touching = exact::touch(first_.simplices[pair.first],
                                         second_.simplices[pair.second], shift, lattice_, signs);
      open += signs > 0 ? 1 : 0;
      work.did(steps_of_decision + steps_of_sign * signs);
      return touching;
    };
    const std::size_t kept = lists::keep_where(batch, decide);
    work.tell();
    tests_ += tests;
    exact_decisions_ += open;
    return kept;
  }

  [[nodiscard]] bool share_vertex(const ContactPair& pair) const {
    for (std::size_t k = 0; k < first_.simplices[pair.first].size; ++k) {
      const std::size_t number = first_.numbers.at(pair.first, k);
      for (std::size_t j = 0; j < second_.simplices[pair.second].size; ++j) {
        if (second_.numbers.at(pair.second, j) == number) return true;
      }
    }
    return false;
  }

  const GatheredSimplices<Dim>& first_;
  const GatheredSimplices<Dim>& second_;
  SharedVertices shared_;
  exact::Lattice lattice_;
  base::ProgressReporter& progress_;
  mutable std::atomic<std::uint64_t> tests_ = 0;
  mutable std::atomic<std::uint64_t> exact_decisions_ = 0;
};

}  // namespace abut::simplices
