#include "api/candidate_pairs.hpp"

#include "api/candidate_test.hpp"
#include "base/workers.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>

namespace abut::api {
namespace {

/// Candidates that a worker takes at a time.
constexpr std::size_t candidates_of_unit = 32 * candidates_of_block;

static_assert(base::PairSink::smallest_room >= candidates_of_block);

/// Writes what a unit of candidates delivers into the sink, a block at a time.
class UnitWriter {
 public:
  UnitWriter(base::PairSink& sink, const base::Origin& origin) : sink_(sink), origin_(origin) {}

  /// Room for the pairs of one block; place() tells where they go.
  void expect_block() {
    if (room_.size() - filled_ >= candidates_of_block) return;
    finish();
    room_ = sink_.room(origin_.worker);
    shifts_ = sink_.shift_room(origin_.worker);
  }

  [[nodiscard]] bool wants_shifts() const noexcept { return !shifts_.empty(); }
  void push(ContactPair pair) { room_[filled_++] = pair; }
  void push(ContactPair pair, const ImageShift& shift) {
    shifts_[filled_] = shift;
    room_[filled_++] = pair;
  }

  void finish() {
    const std::size_t count = filled_;
    filled_ = 0;
    room_ = {};
    if (count > 0) sink_.commit(count, origin_);
  }

 private:
  base::PairSink& sink_;
  base::Origin origin_;
  std::span<ContactPair> room_;
  std::span<ImageShift> shifts_;
  std::size_t filled_ = 0;
};

/// Calls body(first, count, writer, exact_decisions) for each block of candidates.
template <class Body>
void for_each_block(std::size_t candidates, std::size_t workers, base::PairSink& sink,
                    base::DetectionContext& context, Body&& body) {
  sink.expect_workers(workers);
  const std::size_t units = (candidates + candidates_of_unit - 1) / candidates_of_unit;
  std::atomic<std::uint64_t> exact_decisions = 0;
  base::for_each_index(workers, units, [&](std::size_t worker, std::size_t unit) {
    if (worker == 0) context.progress.poll();
    UnitWriter writer(sink, {worker, unit});
    std::uint64_t exact = 0;
    const std::size_t last = std::min(candidates, (unit + 1) * candidates_of_unit);
    for (std::size_t k = unit * candidates_of_unit; k < last; k += candidates_of_block) {
      writer.expect_block();
      body(k, std::min(candidates_of_block, last - k), writer, exact);
    }
    writer.finish();
    exact_decisions += exact;
  });
  context.candidate_tests += candidates;
  context.exact_decisions += exact_decisions;
}

/// The least and the largest number on each axis.
struct ShiftRange {
  std::array<std::int64_t, 3> lower{};
  std::array<std::int64_t, 3> upper{};
  bool empty = true;

  void include(const std::array<std::int64_t, 3>& shift) {
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = empty ? shift[k] : std::min(lower[k], shift[k]);
      upper[k] = empty ? shift[k] : std::max(upper[k], shift[k]);
    }
    empty = false;
  }

  [[nodiscard]] double count() const {
    double product = 1.0;
    for (std::size_t k = 0; k < 3; ++k) product *= static_cast<double>(upper[k] - lower[k] + 1);
    return product;
  }

  [[nodiscard]] std::int64_t number_of(const std::array<std::int64_t, 3>& shift) const {
    std::int64_t number = 0;
    for (std::size_t k = 3; k-- > 0;) {
      number = number * (upper[k] - lower[k] + 1) + shift[k] - lower[k];
    }
    return number;
  }
};

/// The shift between elements as they are placed.
template <int Dim>
std::array<std::int64_t, 3> placed_shift(const ContactPair& pair, const ImageShift& shift,
                                         const Displacement<Dim>& placing) {
  const CellNumbers& first = placing.cells(pair.first);
  const CellNumbers& second = placing.cells(pair.second);
  return {std::int64_t{shift.x} - first[0] + second[0],
          std::int64_t{shift.y} - first[1] + second[1],
          std::int64_t{shift.z} - first[2] + second[2]};
}

}  // namespace

template <int Dim>
CandidatePairs<Dim>::CandidatePairs(base::MemoryMeter& memory)
    : found_(memory),
      order_(memory),
      pairs_(base::make_array_for_overwrite<ContactPair>(memory, 0)),
      shifts_(base::make_array_for_overwrite<ImageShift>(memory, 0)),
      shift_of_(base::make_array_for_overwrite<ShiftNumber>(memory, 0)) {}

template <int Dim>
base::PairSink& CandidatePairs<Dim>::start_anew(bool periodic) {
  periodic_ = periodic;
  size_ = 0;
  found_.start_anew(unlimited_pairs, periodic ? Shifts::stored : Shifts::none);
  return found_;
}

template <int Dim>
bool CandidatePairs<Dim>::finish(const Snapshot<Dim>& now, const Displacement<Dim>& placing) {
  const PairCount count = found_.size();
  const auto pieces = found_.pieces();
  base::make_room(pairs_, count);
  const auto pairs = std::span(pairs_).first(count);
  if (!periodic_) {
    order_.sort(pieces, now.spheres.size(), pairs, now.workers);
    size_ = count;
    return true;
  }
  base::make_room(shifts_, count);
  order_.sort({pieces, found_.shift_pieces()}, now.spheres.size(), pairs,
              std::span(shifts_).first(count), now.workers);
  size_ = count;
  if (number_shifts(placing, now.workers)) return true;
  size_ = 0;
  return false;
}

template <int Dim>
bool CandidatePairs<Dim>::number_shifts(const Displacement<Dim>& placing, std::size_t workers) {
  ShiftRange range;
  for (std::size_t k = 0; k < size_; ++k) {
    range.include(placed_shift(pairs_[k], shifts_[k], placing));
  }
  if (range.count() > std::numeric_limits<ShiftNumber>::max()) return false;
  base::make_room(shift_of_, size_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, size_);
    for (std::size_t k = first; k < last; ++k) {
      const auto shift = placed_shift(pairs_[k], shifts_[k], placing);
      shift_of_[k] = static_cast<ShiftNumber>(range.number_of(shift));
    }
  });
  shift_list_.clear();
  for (std::int64_t z = range.lower[2]; z <= range.upper[2]; ++z) {
    for (std::int64_t y = range.lower[1]; y <= range.upper[1]; ++y) {
      for (std::int64_t x = range.lower[0]; x <= range.upper[0]; ++x) {
        shift_list_.push_back({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                               static_cast<std::int32_t>(z)});
      }
    }
  }
  return true;
}

template <int Dim>
void CandidatePairs<Dim>::deliver_contacts(const Snapshot<Dim>& now,
                                           const Displacement<Dim>& placing, base::PairSink& sink,
                                           base::DetectionContext& context) {
  const auto pairs = std::span<const ContactPair>(pairs_).first(size_);
  if (!periodic_) {
    const OpenCandidateTest<Dim> test(now);
    return for_each_block(size_, now.workers, sink, context,
                          [&](std::size_t first, std::size_t count, UnitWriter& writer,
                              std::uint64_t& exact_decisions) {
                            const auto block = pairs.subspan(first, count);
                            Survivors survivors;
                            test.run(block, survivors, exact_decisions);
                            for (std::size_t k = 0; k < survivors.count; ++k) {
                              writer.push(block[survivors.places[k]]);
                            }
                          });
  }
  const PeriodicCandidateTest<Dim> test(now, placing, shift_list_, images_);
  for_each_block(size_, now.workers, sink, context,
                 [&](std::size_t first, std::size_t count, UnitWriter& writer,
                     std::uint64_t& exact_decisions) {
                   const auto block = pairs.subspan(first, count);
                   const ShiftNumber* const numbers = shift_of_.data() + first;
                   Survivors survivors;
                   test.run(block, numbers, survivors, exact_decisions);
                   for (std::size_t k = 0; k < survivors.count; ++k) {
                     const std::uint16_t place = survivors.places[k];
                     if (writer.wants_shifts()) {
                       writer.push(block[place], test.shift_of(block[place], numbers[place]));
                     } else {
                       writer.push(block[place]);
                     }
                   }
                 });
}

template class CandidatePairs<2>;
template class CandidatePairs<3>;

}  // namespace abut::api
