#include <abut/candidate_list.hpp>

#include "base/callers_exception.hpp"
#include "base/detection_context.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/memory_meter.hpp"
#include "base/shortest_text.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "kernels/simd_level.hpp"
#include "skin/position_tracker.hpp"

#include <abut/detector.hpp>
#include <abut/error.hpp>

#include <array>
#include <limits>
#include <utility>

namespace abut {
namespace {

Options with_skin(Options options, double skin) {
  if (!(skin >= 0.0 && skin <= std::numeric_limits<double>::max())) {
    throw Error(ErrorCode::invalid_input,
                "skin = " + base::shortest_text(skin) + "; it must be finite and not negative");
  }
  options.margin += skin;
  return options;
}

}  // namespace

struct CandidateList::State {
  State(double given_skin, NeighborListKind given_kind, const Options& options)
      : skin(given_skin),
        kind(given_kind),
        detector(with_skin(options, skin)),
        // Rounded down: 2 u more than the subtraction rounds by.
        allowed((detector.options().margin - options.margin) * (1.0 - 0x1p-51)) {}

  const NeighborList& rebuild(const ElementView& elements, const Domain& domain);
  [[nodiscard]] bool needs_rebuild(const ElementView& elements) const;

  double skin;
  NeighborListKind kind;
  Detector detector;
  double allowed;
  base::MemoryMeter memory;
  skin::PositionTracker positions{memory};
  NeighborList none;
  const NeighborList* rows = &none;
  std::uint64_t rebuilds = 0;
};

const NeighborList& CandidateList::State::rebuild(const ElementView& elements,
                                                  const Domain& domain) {
  if (elements.shape() == Shape::box) {
    throw Error(ErrorCode::wrong_usage,
                "candidate lists are of spheres and points; for boxes use a Detector");
  }
  positions.release();
  rows = &none;
  const Options& options = detector.options();
  memory.start_anew(detect::memory_bound(options));
  const NeighborList& made = detector.build_neighbor_list(elements, domain, kind);
  base::DetectionContext context(memory, options.progress);
  context.progress.begin("anchor", elements.size());
  base::letting_through([&] {
    base::reporting_lack_of_memory(memory, [&] { positions.anchor(elements, context.work); });
  });
  rows = &made;
  ++rebuilds;
  return made;
}

bool CandidateList::State::needs_rebuild(const ElementView& elements) const {
  const Options& options = detector.options();
  base::MemoryMeter nothing;
  base::DetectionContext context(nothing, options.progress);
  const std::size_t workers = base::worker_count(options.threads, elements.size());
  return base::letting_through([&] {
    return base::reporting_lack_of_memory([&] {
      return positions.may_have_approached(elements, allowed, kernels::level_to_run(options.simd),
                                           workers, context.work);
    });
  });
}

CandidateList::CandidateList(double skin, NeighborListKind kind, Options options)
    : state_(base::reporting_lack_of_memory(
          [&] { return std::make_unique<State>(skin, kind, options); })) {}

CandidateList::~CandidateList() = default;
CandidateList::CandidateList(CandidateList&&) noexcept = default;
CandidateList& CandidateList::operator=(CandidateList&&) noexcept = default;

const NeighborList& CandidateList::rebuild(const ElementView& elements, const Domain& domain) {
  return state_->rebuild(elements, domain);
}

bool CandidateList::needs_rebuild(const ElementView& elements) const {
  const base::FloatEnvironment environment;
  return state_->needs_rebuild(elements);
}

const NeighborList& CandidateList::rows() const noexcept {
  return *state_->rows;
}

double CandidateList::skin() const noexcept {
  return state_->skin;
}

std::uint64_t CandidateList::rebuilds() const noexcept {
  return state_->rebuilds;
}

}  // namespace abut
