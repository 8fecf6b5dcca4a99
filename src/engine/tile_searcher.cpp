#include "engine/tile_searcher.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace abut::engine {
namespace {

/// Bounds the error of a distance in a tile, whose numbers are below 2:
/// docs/derivations/tile_filter.md.
constexpr float filter_slack = 0x1p-20f;

/// Steps that the decision of a doubtful pair takes, compared to a test in a vector.
constexpr std::uint64_t steps_of_decision = 16;

constexpr std::uint64_t far_tests_between_tells = 256;

/// In a tile of fewer all places of it are room enough.
constexpr std::size_t few_elements = 1 << 13;

}  // namespace

template <int Dim>
TileSearcher<Dim>::TileSearcher(base::MemoryMeter& memory, std::size_t worker)
    : bench_(memory), origin_{worker, 0} {
  job_.slack = filter_slack;
  job_.findings = &findings_;
  job_.owner = this;
  job_.take = [](kernels::SearchJob& job) { static_cast<TileSearcher*>(job.owner)->take(); };
}

template <int Dim>
void TileSearcher<Dim>::start(const Task<Dim>& task) {
  task_ = &task;
  origin_.unit = 0;
  findings_.found = 0;
  findings_.doubts = 0;
  job_.candidate_tests = 0;
  pairs_ = {};
  filled_ = 0;
  far_tests_ = 0;
  tests_told_ = 0;
  work_ = {task.progress, origin_.worker};
  exact_decisions_ = 0;
}

template <int Dim>
void TileSearcher<Dim>::begin_unit(std::uint64_t unit) {
  origin_.unit = unit;
}

template <int Dim>
void TileSearcher<Dim>::finish_unit() {
  take();
  flush();
  pairs_ = {};
}

/// Decides the doubtful pairs and hands all on.
template <int Dim>
void TileSearcher<Dim>::take() {
  work_.did(steps_of_decision * findings_.doubts);
  if (findings_.doubts > 0) settle();
  hand_on();
  tell();
}

/// Drops the doubtful pairs that are none; the others keep their order.
template <int Dim>
void TileSearcher<Dim>::settle() {
  task_->arbiter.decide(findings_, exact_decisions_);
  const std::span doubtful(findings_.doubtful, findings_.doubts);
  const std::span verdicts(findings_.verdict, findings_.doubts);
  findings_.doubts = 0;
  std::size_t k = 0;
  while (k < verdicts.size() && verdicts[k] != kernels::Verdict::apart) ++k;
  if (k == verdicts.size()) return;

  std::size_t kept = doubtful[k];
  for (; k < doubtful.size(); ++k) {
    const bool apart = verdicts[k] == kernels::Verdict::apart;
    const std::size_t begin = doubtful[k] + (apart ? 1 : 0);
    const std::size_t end = k + 1 < doubtful.size() ? doubtful[k + 1] : findings_.found;
    std::copy(findings_.element + begin, findings_.element + end, findings_.element + kept);
    std::copy(findings_.partner + begin, findings_.partner + end, findings_.partner + kept);
    kept += end - begin;
  }
  findings_.found = kept;
}

/// Writes what was found, pair by pair, into the sink's room.
template <int Dim>
void TileSearcher<Dim>::hand_on() {
  for (std::size_t done = 0; done < findings_.found;) {
    if (filled_ == pairs_.size()) {
      flush();
      pairs_ = task_->sink.room(origin_.worker);
    }
    const std::size_t count = std::min(findings_.found - done, pairs_.size() - filled_);
    task_->kernels.pair_up(findings_.element + done, findings_.partner + done, count,
                           pairs_.data() + filled_);
    done += count;
    filled_ += count;
  }
  findings_.found = 0;
}

template <int Dim>
void TileSearcher<Dim>::flush() {
  const std::size_t count = filled_;
  filled_ = 0;
  if (count > 0) task_->sink.commit(count, origin_);
}

/// The tests since it last did.
template <int Dim>
void TileSearcher<Dim>::tell() {
  work_.did(candidate_tests() - std::exchange(tests_told_, candidate_tests()));
}

template <int Dim>
void TileSearcher<Dim>::prepare(const SortedTile<Dim>& tile, double unit) {
  job_.margin = static_cast<float>(task_->margin * unit);
  const std::size_t places =
      tile.size() < few_elements ? tile.size() : std::min(tile.size(), tile.most_places_met());
  const std::size_t room = places + kernels::row_padding + kernels::widest_vector;
  constexpr std::size_t columns = std::extent_v<decltype(job_.block)>;
  base::make_room(bench_.block, columns * room);
  base::make_room(bench_.block_number, room);
  const std::size_t length = bench_.block.size() / columns;
  for (std::size_t k = 0; k < columns; ++k) job_.block[k] = bench_.block.data() + k * length;
  job_.block_number = bench_.block_number.data();
}

template <int Dim>
void TileSearcher<Dim>::search(double unit) {
  search(bench_.tile, kernels::all_layers(bench_.tile.view(), Dim), unit);
}

template <int Dim>
void TileSearcher<Dim>::search(const SortedTile<Dim>& tile, const kernels::Layers& layers,
                               double unit) {
  prepare(tile, unit);
  task_->kernels.search(tile.view(), layers, job_, Dim);
  tell();
}

template <int Dim>
void TileSearcher<Dim>::visit(const TileFrame<Dim>& frame,
                              std::span<const std::uint32_t> visitors) {
  if (visitors.empty()) return;
  prepare(bench_.tile, frame.unit);
  const kernels::TileView& tile = bench_.tile.view();
  for (const std::uint32_t number : visitors) {
    const std::span<const kernels::Run> runs =
        bench_.visits.runs(tile, frame, task_->elements, number);
    work_.did(1 + bench_.visits.rows());
    if (runs.empty()) continue;
    if (const auto visitor = visitor_in(frame, task_->elements, number)) {
      task_->kernels.visit(tile, job_, Dim, *visitor, runs);
    } else {
      meet_far_visitor(runs, number);
    }
    tell();
  }
}

template <int Dim>
void TileSearcher<Dim>::meet_far_visitor(std::span<const kernels::Run> runs,
                                         std::uint32_t visitor) {
  for (const kernels::Run& run : runs) {
    for (std::uint32_t k = run.begin; k < run.end; ++k) {
      const std::uint32_t other = bench_.tile.view().number[k];
      if (++far_tests_ % far_tests_between_tells == 0) tell();
      if (!decide(visitor, other)) continue;
      if (findings_.found == kernels::Findings::room) take();
      findings_.element[findings_.found] = visitor;
      findings_.partner[findings_.found++] = other;
    }
  }
}

template <int Dim>
bool TileSearcher<Dim>::decide(std::uint32_t first, std::uint32_t second) {
  return task_->arbiter.within_reach(first, second, exact_decisions_);
}

template class TileSearcher<2>;
template class TileSearcher<3>;

}  // namespace abut::engine
