#include "engine/search_worker.hpp"

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>

namespace abut::engine {
namespace {

/// Steps that the decision of an undecided pair takes, compared to a test in a vector.
constexpr std::uint64_t steps_of_decision = 16;

constexpr std::uint64_t far_tests_between_tells = 256;

/// A tile with fewer elements gets a block with room for all of them; that of a larger tile has
/// room for as many as one element may meet.
constexpr std::size_t small_tile = 1 << 13;

}  // namespace

template <int Dim>
SearchWorker<Dim>::SearchWorker(base::MemoryMeter& memory, std::size_t worker)
    : memory_(memory), scratch_(std::in_place, memory), origin_{worker, 0} {
  job_.slack = static_cast<float>(kernels::filter_error);  // numbers of a tile are below 2
  job_.hits = &hits_;
  job_.owner = this;
  job_.take = [](kernels::SearchJob& job) { static_cast<SearchWorker*>(job.owner)->take(); };
}

template <int Dim>
void SearchWorker<Dim>::start(const SearchInput<Dim>& input) {
  input_ = &input;
  scratch_->sets.waiting.start();
  origin_.unit = 0;
  hits_.found = 0;
  hits_.undecided_count = 0;
  hits_.copies = nullptr;
  job_.has_many_undecided = false;
  job_.has_few_hits = false;
  job_.wide_vectors = input.wide_vectors;
  job_.candidate_tests = 0;
  pairs_ = {};
  filled_ = 0;
  far_tests_ = 0;
  tests_told_ = 0;
  work_ = {input.progress, origin_.worker};
  exact_decisions_ = 0;
}

template <int Dim>
void SearchWorker<Dim>::free_arrays() {
  scratch_.reset();
  scratch_.emplace(memory_);
}

template <int Dim>
void SearchWorker<Dim>::begin_unit(std::uint64_t unit) {
  origin_.unit = unit;
  input_->sink.begin_unit(origin_);
}

template <int Dim>
void SearchWorker<Dim>::finish_unit() {
  hand_over();
  input_->sink.finish_unit(origin_);
}

template <int Dim>
void SearchWorker<Dim>::hand_over() {
  take();
  flush();
  pairs_ = {};
}

template <int Dim>
void SearchWorker<Dim>::count_in(std::uint64_t tests, std::uint64_t decisions) noexcept {
  far_tests_ += tests;
  tests_told_ += tests;
  exact_decisions_ += decisions;
}

/// Decides the undecided pairs and hands all on.
template <int Dim>
void SearchWorker<Dim>::take() {
  work_.did(steps_of_decision * hits_.undecided_count);
  if (input_->part.is_part()) number_as_given();
  if (hits_.undecided_count > 0) settle();
  hand_on();
  tell();
}

/// Gives the elements of a part their numbers in the whole, and drops pairs that are found
/// elsewhere.
template <int Dim>
void SearchWorker<Dim>::number_as_given() {
  const PartNumbers& part = input_->part;
  std::size_t kept = 0;
  std::size_t undecided = 0;
  std::size_t kept_undecided = 0;
  for (std::size_t k = 0; k < hits_.found; ++k) {
    const bool is_undecided = undecided < hits_.undecided_count && hits_.undecided[undecided] == k;
    const bool is_wanted = part.is_wanted(hits_.element[k], hits_.partner[k]);
    // One that is dropped is overwritten.
    hits_.element[kept] = part.given[hits_.element[k]];
    hits_.partner[kept] = part.given[hits_.partner[k]];
    if (is_undecided) {
      hits_.undecided[kept_undecided] = static_cast<std::uint32_t>(kept);
      kept_undecided += is_wanted ? 1 : 0;
      ++undecided;
    }
    kept += is_wanted ? 1 : 0;
  }
  hits_.found = kept;
  hits_.undecided_count = kept_undecided;
}

/// Drops the undecided pairs that are none; the others keep their order.
template <int Dim>
void SearchWorker<Dim>::settle() {
  input_->decider.decide(hits_, exact_decisions_);
  const std::span undecided(hits_.undecided, hits_.undecided_count);
  const std::span verdicts(hits_.verdict, hits_.undecided_count);
  hits_.undecided_count = 0;
  std::size_t k = 0;
  while (k < verdicts.size() && verdicts[k] != kernels::Verdict::apart) ++k;
  if (k == verdicts.size()) return;

  std::size_t kept = undecided[k];
  for (; k < undecided.size(); ++k) {
    const bool apart = verdicts[k] == kernels::Verdict::apart;
    const std::size_t begin = undecided[k] + (apart ? 1 : 0);
    const std::size_t end = k + 1 < undecided.size() ? undecided[k + 1] : hits_.found;
    std::copy(hits_.element + begin, hits_.element + end, hits_.element + kept);
    std::copy(hits_.partner + begin, hits_.partner + end, hits_.partner + kept);
    kept += end - begin;
  }
  hits_.found = kept;
}

/// Writes what was found, pair by pair, into the sink's room.
template <int Dim>
void SearchWorker<Dim>::hand_on() {
  for (std::size_t done = 0; done < hits_.found;) {
    if (filled_ == pairs_.size()) {
      flush();
      pairs_ = input_->sink.buffer(origin_.worker);
    }
    const std::size_t count = std::min(hits_.found - done, pairs_.size() - filled_);
    input_->kernels.pair_up(hits_.element + done, hits_.partner + done, count,
                            pairs_.data() + filled_);
    done += count;
    filled_ += count;
  }
  hits_.found = 0;
}

template <int Dim>
void SearchWorker<Dim>::flush() {
  const std::size_t count = filled_;
  filled_ = 0;
  if (count > 0) input_->sink.commit(count, origin_);
}

/// The tests since it last did.
template <int Dim>
void SearchWorker<Dim>::tell() {
  work_.did(candidate_tests() - std::exchange(tests_told_, candidate_tests()));
}

template <int Dim>
void SearchWorker<Dim>::prepare(const SortedTile<Dim>& tile, double unit) {
  job_.margin = static_cast<float>(input_->margin * unit);
  const std::size_t places =
      tile.size() < small_tile ? tile.size() : std::min(tile.size(), tile.most_places_met());
  constexpr std::size_t vector = kernels::widest_vector;
  constexpr std::size_t columns = std::extent_v<decltype(job_.block)>;
  const std::size_t vectors = (places + kernels::row_padding) / vector + 2;
  const std::size_t length = vectors * vector;
  base::make_room(scratch_->block, columns * length + vector);
  base::make_room(scratch_->block_number, length);
  // A vector that lies in two cache lines takes twice as long to read.
  void* first = scratch_->block.data();
  std::size_t bytes = scratch_->block.size() * sizeof(float);
  std::align(vector * sizeof(float), columns * length * sizeof(float), first, bytes);
  for (std::size_t k = 0; k < columns; ++k) {
    job_.block[k] = static_cast<float*>(first) + k * length;
  }
  job_.block_number = scratch_->block_number.data();
}

template <int Dim>
void SearchWorker<Dim>::search(double unit) {
  search(scratch_->tile, kernels::all_layers(scratch_->tile.view(), Dim), unit);
}

template <int Dim>
void SearchWorker<Dim>::search(const SortedTile<Dim>& tile, const kernels::Layers& layers,
                               double unit) {
  prepare(tile, unit);
  input_->kernels.search(tile.view(), layers, job_, Dim);
  tell();
}

template <int Dim>
void SearchWorker<Dim>::search(const kernels::PlaneView& plane, double unit) {
  job_.margin = static_cast<float>(input_->margin * unit);
  input_->plane_kernels.search(plane, job_, Dim);
  tell();
}

template <int Dim>
void SearchWorker<Dim>::search(const kernels::LayerPair& layers) {
  input_->layer_kernels.search(layers, job_, Dim);
  tell();
}

template <int Dim>
void SearchWorker<Dim>::search(const kernels::ThreeLayers& layers,
                               std::span<const kernels::FarSphere> far) {
  input_->layer_kernels.search_near(layers, job_, Dim);
  if (!far.empty()) input_->layer_kernels.search_far(layers, far.data(), far.size(), job_, Dim);
  tell();
}

template <int Dim>
void SearchWorker<Dim>::search_coarse(const kernels::ThreeLayers& layers,
                                      std::span<const kernels::FarSphere> coarse) {
  if (coarse.empty()) return;
  input_->layer_kernels.search_coarse(layers, coarse.data(), coarse.size(), job_, Dim);
  tell();
}

template <int Dim>
void SearchWorker<Dim>::test_coarse(const TileFrame<Dim>& frame,
                                    std::span<const std::uint32_t> coarse_elements) {
  if (coarse_elements.empty()) return;
  prepare(scratch_->tile, frame.unit);
  const kernels::TileView& tile = scratch_->tile.view();
  for (const std::uint32_t number : coarse_elements) {
    const std::span<const kernels::Run> runs =
        scratch_->cross_level.runs(tile, frame, input_->elements, number);
    work_.did(1 + scratch_->cross_level.rows());
    if (runs.empty()) continue;
    if (const auto coarse = coarse_element_in(frame, input_->elements, number)) {
      input_->kernels.test_coarse(tile, job_, Dim, *coarse, runs);
    } else {
      test_far_coarse(runs, number);
    }
    tell();
  }
}

template <int Dim>
void SearchWorker<Dim>::test_far_coarse(std::span<const kernels::Run> runs, std::uint32_t coarse) {
  for (const kernels::Run& run : runs) {
    for (std::uint32_t k = run.begin; k < run.end; ++k) {
      test_pair(coarse, scratch_->tile.view().number[k]);
    }
  }
}

template <int Dim>
void SearchWorker<Dim>::test_pair(std::uint32_t first, std::uint32_t second) {
  if (++far_tests_ % far_tests_between_tells == 0) tell();
  if (!decide(first, second)) return;
  if (hits_.found == kernels::HitBuffer::size) take();
  hits_.element[hits_.found] = first;
  hits_.partner[hits_.found++] = second;
}

template <int Dim>
bool SearchWorker<Dim>::decide(std::uint32_t first, std::uint32_t second) {
  const PartNumbers& part = input_->part;
  if (!part.is_part()) return input_->decider.within_reach(first, second, exact_decisions_);
  return part.is_wanted(first, second) &&
         input_->decider.within_reach(part.given[first], part.given[second], exact_decisions_);
}

template class SearchWorker<2>;
template class SearchWorker<3>;

}  // namespace abut::engine
