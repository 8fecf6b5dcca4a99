#include "engine/tile_searcher.hpp"

#include <algorithm>

namespace abut::engine {
namespace {

/// Bounds the error of a distance in a tile, whose numbers are below 2:
/// docs/derivations/tile_filter.md.
constexpr float filter_slack = 0x1p-20f;

/// With fewer hits than one in so many tests, three of four vectors are without one.
constexpr std::uint64_t tests_for_few_hits = 24;

constexpr std::uint64_t tests_between_polls = 1 << 18;

}  // namespace

template <int Dim>
TileSearcher<Dim>::TileSearcher(base::MemoryMeter& memory, std::size_t worker)
    : bench_(memory), origin_{worker, 0} {
  job_.slack = filter_slack;
  job_.owner = this;
  job_.flush = [](kernels::SearchJob& job) {
    auto& self = *static_cast<TileSearcher*>(job.owner);
    self.flush();
    self.ask_for_room();
  };
  job_.decide = [](kernels::SearchJob& job, std::uint32_t first, std::uint32_t second) {
    return static_cast<TileSearcher*>(job.owner)->decide(first, second);
  };
}

template <int Dim>
void TileSearcher<Dim>::start(const Task<Dim>& task) {
  task_ = &task;
  origin_.unit = 0;
  job_.pairs = nullptr;
  job_.filled = 0;
  job_.capacity = 0;
  job_.candidate_tests = 0;
  pairs_ = 0;
  far_tests_ = 0;
  next_poll_ = 0;
  exact_decisions_ = 0;
}

template <int Dim>
void TileSearcher<Dim>::begin_unit(std::uint64_t unit) {
  origin_.unit = unit;
}

template <int Dim>
void TileSearcher<Dim>::finish_unit() {
  flush();
  job_.pairs = nullptr;
  job_.capacity = 0;
}

template <int Dim>
void TileSearcher<Dim>::flush() {
  const std::size_t count = job_.filled;
  job_.filled = 0;
  pairs_ += count;
  if (count > 0) task_->sink.commit(count, origin_);
  poll();
}

/// The caller's hook is asked from the caller's thread, which is the first worker's.
template <int Dim>
void TileSearcher<Dim>::poll() {
  if (origin_.worker != 0 || candidate_tests() < next_poll_) return;
  next_poll_ = candidate_tests() + tests_between_polls;
  task_->progress.poll();
}

template <int Dim>
void TileSearcher<Dim>::ask_for_room() {
  const std::span<ContactPair> room = task_->sink.room(origin_.worker);
  job_.pairs = room.data();
  job_.capacity = room.size();
}

template <int Dim>
void TileSearcher<Dim>::prepare(double unit) {
  if (job_.pairs == nullptr) ask_for_room();
  job_.few_hits = (pairs_ + job_.filled) * tests_for_few_hits < job_.candidate_tests;
  job_.margin = static_cast<float>(task_->margin * unit);
  const std::size_t elements = bench_.tile.size();
  const std::size_t padded = elements + 2 * kernels::widest_vector;
  base::make_room(bench_.block, 4 * padded);
  base::make_room(bench_.block_number, padded);
  const std::size_t column = bench_.block.size() / 4;
  for (std::size_t k = 0; k < 4; ++k) job_.block[k] = bench_.block.data() + k * column;
  job_.block_number = bench_.block_number.data();
}

template <int Dim>
void TileSearcher<Dim>::search(double unit) {
  prepare(unit);
  task_->kernels.search(bench_.tile.view(), job_, Dim);
  poll();
}

template <int Dim>
void TileSearcher<Dim>::visit(const TileFrame<Dim>& frame,
                              std::span<const std::uint32_t> visitors) {
  if (visitors.empty()) return;
  prepare(frame.unit);
  const kernels::TileView& tile = bench_.tile.view();
  for (const std::uint32_t number : visitors) {
    const base::Sphere<Dim>& sphere = task_->spheres[number];
    const std::span<const kernels::Run> runs = bench_.visits.runs(tile, frame, sphere);
    if (runs.empty()) continue;
    if (const auto visitor = visitor_in(frame, sphere, number)) {
      task_->kernels.visit(tile, job_, Dim, *visitor, runs);
    } else {
      meet_far_visitor(runs, number);
    }
  }
}

template <int Dim>
void TileSearcher<Dim>::meet_far_visitor(std::span<const kernels::Run> runs,
                                         std::uint32_t visitor) {
  for (const kernels::Run& run : runs) {
    for (std::uint32_t k = run.begin; k < run.end; ++k) {
      const std::uint32_t other = bench_.tile.view().number[k];
      ++far_tests_;
      if (!decide(visitor, other)) continue;
      job_.pairs[job_.filled++] = {std::min(visitor, other), std::max(visitor, other)};
      if (job_.filled + 2 * kernels::widest_vector > job_.capacity) job_.flush(job_);
    }
  }
}

template <int Dim>
bool TileSearcher<Dim>::decide(std::uint32_t first, std::uint32_t second) {
  return base::within_reach(task_->originals[first], task_->originals[second],
                            task_->original_margin, exact_decisions_);
}

template class TileSearcher<2>;
template class TileSearcher<3>;

}  // namespace abut::engine
