#include <abut/detector.hpp>

#include "base/lack_of_memory.hpp"
#include "detect/detector_state.hpp"

#include <utility>

namespace abut {

Detector::Detector(Options options)
    : state_(base::reporting_lack_of_memory(
          [&] { return std::make_unique<State>(std::move(options)); })) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const Options& Detector::options() const noexcept {
  return state_->options;
}

void Detector::set_options(Options options) {
  state_->options = std::move(options);
}

void Detector::set_skin(Skin skin) {
  base::reporting_lack_of_memory([&] { state_->run.skin().set_skin(skin); });
}

void Detector::set_ids(std::span<const std::uint64_t> ids) {
  base::reporting_lack_of_memory([&] { state_->run.skin().set_ids(ids); });
}

Skin Detector::skin() const noexcept {
  return state_->run.skin().skin();
}

const SkinStatistics& Detector::skin_statistics() const noexcept {
  return state_->run.skin().statistics();
}

const PairList& Detector::find_contact_pairs(const ElementView& elements, const Domain& domain) {
  PairList& list = state_->pairs;
  list.statistics_ = state_->run.list_pairs({elements, domain, state_->options},
                                            {list.pairs_, list.shifts_, list.geometry_});
  return list;
}

Statistics Detector::count_contact_pairs(const ElementView& elements, const Domain& domain) {
  return state_->run.visit_batches({elements, domain, state_->options}, {});
}

Statistics Detector::for_each_batch(const ElementView& elements, const Domain& domain,
                                    const PairBatchVisitor& visitor) {
  return state_->run.visit_batches({elements, domain, state_->options},
                                   lists::visitors_of(visitor));
}

Statistics Detector::for_each_shifted_batch(const ElementView& elements, const Domain& domain,
                                            const ShiftedBatchVisitor& visitor) {
  return state_->run.visit_batches({elements, domain, state_->options},
                                   lists::visitors_of(visitor));
}

const NeighborList& Detector::build_neighbor_list(const ElementView& elements, const Domain& domain,
                                                  NeighborListKind kind) {
  NeighborList& list = state_->neighbors;
  list.statistics_ =
      state_->run.list_neighbors({elements, domain, state_->options}, kind,
                                 {list.offsets_, list.neighbors_, list.shifts_, list.geometry_});
  return list;
}

const PairList& Detector::find_contact_pairs(const ElementView& first, const ElementView& second,
                                             const Domain& domain) {
  PairList& list = state_->pairs;
  list.statistics_ = state_->run.list_pairs({first, domain, state_->options, &second},
                                            {list.pairs_, list.shifts_, list.geometry_});
  return list;
}

Statistics Detector::count_contact_pairs(const ElementView& first, const ElementView& second,
                                         const Domain& domain) {
  return state_->run.visit_batches({first, domain, state_->options, &second}, {});
}

Statistics Detector::for_each_batch(const ElementView& first, const ElementView& second,
                                    const Domain& domain, const PairBatchVisitor& visitor) {
  return state_->run.visit_batches({first, domain, state_->options, &second},
                                   lists::visitors_of(visitor));
}

Statistics Detector::for_each_shifted_batch(const ElementView& first, const ElementView& second,
                                            const Domain& domain,
                                            const ShiftedBatchVisitor& visitor) {
  return state_->run.visit_batches({first, domain, state_->options, &second},
                                   lists::visitors_of(visitor));
}

const NeighborList& Detector::build_neighbor_list(const ElementView& first,
                                                  const ElementView& second, const Domain& domain) {
  NeighborList& list = state_->neighbors;
  list.statistics_ =
      state_->run.list_neighbors({first, domain, state_->options, &second}, NeighborListKind::half,
                                 {list.offsets_, list.neighbors_, list.shifts_, list.geometry_});
  return list;
}

PairList Detector::take_pairs() noexcept {
  return std::exchange(state_->pairs, {});
}

NeighborList Detector::take_neighbors() noexcept {
  return std::exchange(state_->neighbors, {});
}

}  // namespace abut
