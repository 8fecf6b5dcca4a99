#include "lists/found_pairs.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut::lists {
namespace {

/// Chunks double up to 4 MiB, so that pairs and shifts are whole large pages (decision 0003).
constexpr std::size_t smallest_chunk = 4096;
constexpr std::size_t largest_chunk = std::size_t{1} << 19;

}  // namespace

FoundPairs::~FoundPairs() {
  for (const auto& worker : workers_) {
    for (const Chunk& chunk : worker->chunks) {
      memory_.give_back_pairs(chunk.pairs.size() * sizeof(ContactPair));
      memory_.give_back_pairs(chunk.shifts.size() * sizeof(ImageShift));
    }
  }
}

void FoundPairs::start_anew(const PairDemand& demand) {
  demand_ = demand;
  OutputBuffer& buffer = demand_.buffer;
  if (demand.shifts == Shifts::stored) {
    buffer.pairs = buffer.pairs.first(std::min(buffer.pairs.size(), buffer.shifts.size()));
  }
  comes_in_canonical_order_ = false;
  in_buffer_ = 0;
  total_ = 0;
  for (const auto& worker : workers_) {
    worker->current = 0;
    worker->segments.clear();
    for (Chunk& chunk : worker->chunks) chunk.filled = 0;
  }
}

void FoundPairs::expect_workers(std::size_t count) {
  while (workers_.size() < count) workers_.push_back(std::make_unique<Worker>());
  if (count > 1 || must_be_sorted()) demand_.buffer = {};
}

std::span<ContactPair> FoundPairs::buffer(std::size_t number) {
  if (buffer_is_next()) return demand_.buffer.pairs.subspan(in_buffer_);
  Worker& worker = *workers_[number];
  const auto free_in = [&](std::size_t k) {
    return worker.chunks[k].pairs.size() - worker.chunks[k].filled;
  };
  while (worker.current < worker.chunks.size() && free_in(worker.current) < smallest_buffer) {
    ++worker.current;
  }
  if (worker.current == worker.chunks.size()) add_chunk(worker);
  Chunk& chunk = worker.chunks[worker.current];
  return std::span(chunk.pairs).subspan(chunk.filled);
}

std::span<ImageShift> FoundPairs::shift_buffer(std::size_t number) {
  if (demand_.shifts == Shifts::none) return {};
  if (buffer_is_next()) return demand_.buffer.shifts.subspan(in_buffer_);
  Worker& worker = *workers_[number];
  Chunk& chunk = worker.chunks[worker.current];
  if (chunk.shifts.empty()) make_room_for_shifts(chunk);
  return std::span(chunk.shifts).subspan(chunk.filled);
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

std::pair<std::span<const ContactPair>, const ImageShift*> FoundPairs::take(Worker& worker,
                                                                            std::size_t count) {
  const bool with_shifts = demand_.shifts == Shifts::stored;
  if (buffer_is_next()) {
    const OutputBuffer& buffer = demand_.buffer;
    const std::size_t begin = std::exchange(in_buffer_, in_buffer_ + count);
    return {buffer.pairs.subspan(begin, count), with_shifts ? &buffer.shifts[begin] : nullptr};
  }
  Chunk& chunk = worker.chunks[worker.current];
  const std::size_t begin = std::exchange(chunk.filled, chunk.filled + count);
  return {std::span<const ContactPair>(chunk.pairs).subspan(begin, count),
          with_shifts ? chunk.shifts.data() + begin : nullptr};
}

void FoundPairs::commit(std::size_t count, const base::Origin& origin) {
  if ((total_ += count) > demand_.limit) {
    throw Error(ErrorCode::limit_exceeded,
                "there are more than " + std::to_string(demand_.limit) +
                    " contact pairs, the limit that was set; raise it, or count the pairs "
                    "without storing them");
  }
  Worker& worker = *workers_[origin.worker];
  const auto [added, shifts] = take(worker, count);
  if (!worker.segments.empty()) {
    PairSegment& last = worker.segments.back();
    // A chunk may begin where the caller's buffer ends; the two are not one segment.
    const auto* const end_of_buffer = demand_.buffer.pairs.data() + demand_.buffer.pairs.size();
    const bool is_elsewhere = added.data() == end_of_buffer;
    if (last.unit == origin.unit && last.pairs.data() + last.pairs.size() == added.data() &&
        !is_elsewhere) {
      last.pairs = {last.pairs.data(), last.pairs.size() + count};
      return;
    }
  }
  worker.segments.push_back({origin.unit, worker.segments.size(), added, shifts});
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
  for (const PairSegment& segment : segments_) {
    pieces_.push_back(segment.pairs);
    if (demand_.shifts == Shifts::stored) {
      shift_pieces_.emplace_back(segment.shifts, segment.pairs.size());
    }
  }
  return {pieces_, shift_pieces_};
}

}  // namespace abut::lists
