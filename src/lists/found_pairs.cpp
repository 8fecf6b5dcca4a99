#include "lists/found_pairs.hpp"

#include "lists/copy_in_pieces.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace abut::lists {
namespace {

/// Chunks double up to 4 MiB, so that pairs and shifts are whole large pages (decision 0003).
constexpr std::size_t smallest_chunk = 4096;
constexpr std::size_t largest_chunk = std::size_t{1} << 19;

/// The share of a search that tells what the rest of it finds, and the room for more than that:
/// what is not written to takes addresses only, and too little would be written twice.
constexpr double least_share = 1.0 / 16.0;
constexpr double room_to_spare = 1.125;

}  // namespace

bool FoundPairs::PairSegment::is_followed_by(const PairSegment& next) const noexcept {
  if (unit != next.unit || (pairs == nullptr) != (next.pairs == nullptr)) return false;
  return pairs == nullptr ? place + count == next.place : pairs + count == next.pairs;
}

FoundPairs::~FoundPairs() {
  for (const auto& worker : workers_) {
    for (const Chunk& chunk : worker->chunks) {
      memory_.give_back_pairs(chunk.pairs.size() * sizeof(ContactPair));
      memory_.give_back_pairs(chunk.shifts.size() * sizeof(ImageShift));
    }
  }
}

void FoundPairs::start_anew(const PairDemand& demand, base::ProgressReporter* progress) {
  demand_ = demand;
  progress_ = progress;
  comes_in_canonical_order_ = false;
  total_ = 0;
  places_.clear();
  list_has_room_ = demand.list != nullptr && !demand.list->room().pairs.empty();
  list_can_grow_ = true;
  for (const auto& worker : workers_) {
    worker->current = 0;
    worker->segments.clear();
    worker->in_list = 0;
    worker->found = 0;
    for (Chunk& chunk : worker->chunks) chunk.filled = 0;
  }
}

void FoundPairs::expect_workers(std::size_t count) {
  while (workers_.size() < count) workers_.push_back(std::make_unique<Worker>());
  worker_count_ = count;
  if (must_be_sorted()) {
    demand_.list = nullptr;
    list_has_room_ = false;
  }
  if (demand_.list == nullptr) return;
  for (std::size_t k = 0; k < count; ++k) workers_[k]->work = base::WorkCounter(*progress_, k);
}

void FoundPairs::expect_units(std::uint64_t first, std::size_t count) {
  if (worker_count_ > 1 && demand_.list != nullptr) places_.start(first, count, total_);
}

void FoundPairs::begin_unit(const base::Origin& origin) {
  if (worker_count_ == 1) return;
  Worker& worker = *workers_[origin.worker];
  worker.unit = origin.unit;
  worker.found = 0;
}

void FoundPairs::finish_unit(const base::Origin& origin) {
  if (worker_count_ == 1 || demand_.list == nullptr) return;
  Worker& worker = *workers_[origin.worker];
  places_.finish(origin.unit, worker.found);
  bring_to_list(worker);
}

/// A single worker's pairs stand one after the other, as if they were of one unit.
std::optional<std::size_t> FoundPairs::place_of(std::uint64_t unit) const noexcept {
  if (worker_count_ == 1) return 0;
  return places_.of(unit);
}

std::span<ContactPair> FoundPairs::buffer(std::size_t number) {
  Worker& worker = *workers_[number];
  const auto free_in = [&](std::size_t k) {
    return worker.chunks[k].pairs.size() - worker.chunks[k].filled;
  };
  if (const OutputBuffer room = next_in_list(worker); worker.writes_to_list) return room.pairs;
  while (worker.current < worker.chunks.size() && free_in(worker.current) < smallest_buffer) {
    ++worker.current;
  }
  if (worker.current == worker.chunks.size()) {
    grow_list(worker.work);
    if (const OutputBuffer room = next_in_list(worker); worker.writes_to_list) return room.pairs;
    add_chunk(worker);
  }
  Chunk& chunk = worker.chunks[worker.current];
  return std::span(chunk.pairs).subspan(chunk.filled);
}

std::span<ImageShift> FoundPairs::shift_buffer(std::size_t number) {
  if (!with_shifts()) return {};
  Worker& worker = *workers_[number];
  if (worker.writes_to_list) return next_in_list(worker).shifts;
  Chunk& chunk = worker.chunks[worker.current];
  if (chunk.shifts.empty()) make_room_for_shifts(chunk);
  return std::span(chunk.shifts).subspan(chunk.filled);
}

OutputBuffer FoundPairs::next_in_list(Worker& worker) {
  bring_to_list(worker);
  worker.writes_to_list = false;
  const bool all_are_there = worker.in_list == worker.segments.size();
  const auto place = place_of(worker.unit);
  if (!list_has_room_ || !all_are_there || !place) return {};
  const OutputBuffer room = room_in_list(*place + worker.found);
  worker.writes_to_list = !room.pairs.empty();
  return room;
}

OutputBuffer FoundPairs::room_in_list(std::size_t begin) {
  const std::size_t size = demand_.list->room().pairs.size();
  if (size < begin + smallest_buffer) return {};
  // As chunks grow, so does the part that is used.
  const std::size_t end = std::min(size, begin + std::clamp(begin, smallest_chunk, largest_chunk));
  const std::lock_guard lock(list_mutex_);
  demand_.list->use(end);
  return demand_.list->room().part(begin, end - begin);
}

/// Copies what a worker has in chunks, as far as its place in the list is known.
void FoundPairs::bring_to_list(Worker& worker) {
  if (!list_has_room_ || worker.in_list == worker.segments.size()) return;
  const OutputBuffer list = demand_.list->room();
  for (; worker.in_list < worker.segments.size(); ++worker.in_list) {
    PairSegment& segment = worker.segments[worker.in_list];
    const auto place = place_of(segment.unit);
    if (!place || *place + segment.number + segment.count > list.pairs.size()) return;
    segment.place = *place + segment.number;
    {
      const std::lock_guard lock(list_mutex_);
      demand_.list->use(segment.place + segment.count);
    }
    const OutputBuffer target = list.part(segment.place, segment.count);
    copy_in_pieces(std::span(segment.pairs, segment.count), target.pairs, worker.work);
    if (with_shifts()) {
      copy_in_pieces(std::span(segment.shifts, segment.count), target.shifts, worker.work);
    }
    segment.pairs = nullptr;
  }
  worker.current = 0;
  for (Chunk& chunk : worker.chunks) chunk.filled = 0;
}

/// 0 if too little of the search is done.
std::size_t FoundPairs::expected_total() const noexcept {
  const double share = progress_->share_done();
  const PairCount found = total_;
  if (found == 0 || share < least_share) return 0;
  const double total = static_cast<double>(found) / std::min(share, 1.0);
  return static_cast<std::size_t>(room_to_spare * total);
}

/// A list that several workers write to stays where it is. One that must grow once more, since more
/// came than was expected, does so by a half at least.
void FoundPairs::grow_list(base::WorkCounter& work) {
  if (demand_.list == nullptr) return;
  const std::lock_guard lock(list_mutex_);
  if (!list_can_grow_ || (worker_count_ > 1 && list_has_room_)) return;
  const std::size_t expected = expected_total();
  if (expected == 0) return;
  const std::size_t had = demand_.list->room().pairs.size();
  list_can_grow_ = demand_.list->grow(std::max(expected, had + had / 2), kept_in_list(), work);
  if (list_can_grow_) list_has_room_ = true;
}

std::size_t FoundPairs::kept_in_list() const noexcept {
  std::size_t end = 0;
  for (const auto& worker : workers_) {
    if (worker->in_list == 0) continue;
    const PairSegment& last = worker->segments[worker->in_list - 1];
    end = std::max(end, last.place + last.count);
  }
  return end;
}

void FoundPairs::make_room_for_shifts(Chunk& chunk) {
  const std::size_t bytes = chunk.pairs.size() * sizeof(ImageShift);
  memory_.take_for_pairs(bytes);
  try {
    chunk.shifts.resize(chunk.pairs.size());
  } catch (...) {
    memory_.give_back_pairs(bytes);
    throw;
  }
}

void FoundPairs::add_chunk(Worker& worker) {
  const std::size_t size = worker.chunks.empty()
                               ? smallest_chunk
                               : std::min(2 * worker.chunks.back().pairs.size(), largest_chunk);
  memory_.take_for_pairs(size * sizeof(ContactPair));
  try {
    worker.chunks.push_back({PairArray(size), 0, {}});
  } catch (...) {
    memory_.give_back_pairs(size * sizeof(ContactPair));
    throw;
  }
}

void FoundPairs::commit(std::size_t count, const base::Origin& origin) {
  if ((total_ += count) > demand_.limit) {
    throw Error(ErrorCode::limit_exceeded,
                "there are more than " + std::to_string(demand_.limit) +
                    " contact pairs, the limit that was set; raise it, or count the pairs "
                    "without storing them");
  }
  Worker& worker = *workers_[origin.worker];
  PairSegment added{
      origin.unit, std::exchange(worker.found, worker.found + count), count, nullptr, nullptr, 0};
  if (worker.writes_to_list) {
    added.place = *place_of(origin.unit) + added.number;
  } else {
    Chunk& chunk = worker.chunks[worker.current];
    added.pairs = chunk.pairs.data() + chunk.filled;
    if (with_shifts()) added.shifts = chunk.shifts.data() + chunk.filled;
    chunk.filled += count;
  }
  if (!worker.segments.empty() && worker.segments.back().is_followed_by(added)) {
    worker.segments.back().count += count;
    return;
  }
  worker.segments.push_back(added);
  if (worker.writes_to_list) ++worker.in_list;
}

FoundPieces FoundPairs::pieces() {
  segments_.clear();
  for (const auto& worker : workers_) {
    segments_.insert(segments_.end(), worker->segments.begin(), worker->segments.end());
  }
  // The segments of a unit are all one worker's.
  std::sort(segments_.begin(), segments_.end(), [](const PairSegment& a, const PairSegment& b) {
    return a.unit != b.unit ? a.unit < b.unit : a.number < b.number;
  });
  pieces_.clear();
  shift_pieces_.clear();
  const OutputBuffer list = demand_.list == nullptr ? OutputBuffer{} : demand_.list->room();
  for (const PairSegment& segment : segments_) {
    const bool is_in_list = segment.pairs == nullptr;
    const OutputBuffer there =
        is_in_list ? list.part(segment.place, segment.count) : OutputBuffer{};
    pieces_.push_back(is_in_list ? there.pairs : std::span(segment.pairs, segment.count));
    if (!with_shifts()) continue;
    shift_pieces_.push_back(is_in_list ? there.shifts : std::span(segment.shifts, segment.count));
  }
  return {pieces_, shift_pieces_};
}

}  // namespace abut::lists
