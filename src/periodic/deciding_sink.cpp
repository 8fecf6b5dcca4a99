#include "periodic/deciding_sink.hpp"

namespace abut::periodic {

template <int Dim>
void DecidingSink<Dim>::start_anew(base::PairSink& next, const Images<Dim>& images,
                                   const engine::ExactDecider& decider) {
  next_ = &next;
  images_ = &images;
  decider_ = &decider;
  workers_.clear();
}

template <int Dim>
void DecidingSink<Dim>::expect_workers(std::size_t count) {
  workers_.resize(count);
  next_->expect_workers(count);
}

template <int Dim>
std::span<ContactPair> DecidingSink<Dim>::buffer(std::size_t worker) {
  workers_[worker].pairs = next_->buffer(worker);
  return workers_[worker].pairs;
}

template <int Dim>
void DecidingSink<Dim>::commit(std::size_t count, const base::Origin& origin) {
  OfWorker& own = workers_[origin.worker];
  std::size_t kept = 0;
  for (const ContactPair& pair : own.pairs.first(count)) {
    if (is_pair(pair, own.exact_decisions)) own.pairs[kept++] = pair;
  }
  if (kept > 0) next_->commit(kept, origin);
}

template <int Dim>
std::uint64_t DecidingSink<Dim>::exact_decisions() const noexcept {
  std::uint64_t sum = 0;
  for (const OfWorker& worker : workers_) sum += worker.exact_decisions;
  return sum;
}

template <int Dim>
bool DecidingSink<Dim>::is_pair(const ContactPair& pair, std::uint64_t& exact_decisions) const {
  return images_->are_as_given(pair.first, pair.second) ||
         decider_->within_reach(pair.first, pair.second, exact_decisions);
}

template class DecidingSink<2>;
template class DecidingSink<3>;

}  // namespace abut::periodic
