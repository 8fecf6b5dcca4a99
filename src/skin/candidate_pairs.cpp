#include "skin/candidate_pairs.hpp"

#include "base/asking_workers.hpp"
#include "base/opposite_shift.hpp"
#include "skin/candidate_insertion.hpp"
#include "skin/candidate_writer.hpp"
#include "skin/following_pass.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace abut::skin {
namespace {

/// Words of candidates, and candidates in canonical order, that a worker takes at a time.
constexpr std::size_t candidates_of_word = 64;
constexpr std::size_t words_of_unit = 128;
constexpr std::size_t candidates_of_run = candidates_of_word * words_of_unit;
constexpr std::uint64_t steps_of_exact_decision = 64;
constexpr std::size_t candidates_of_unit = 64 * CandidateWriter::most;

/// Of more undecided candidates, all elements are better gathered than read one by one.
constexpr std::size_t candidates_for_an_undecided = 64;

/// Shifts that can be numbered.
constexpr double most_shifts = std::numeric_limits<ShiftNumber>::max();

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
    for (std::size_t k = 0; k < 3; ++k) {
      number = number * (upper[k] - lower[k] + 1) + shift[k] - lower[k];
    }
    return number;
  }
};

/// The shift between elements as they are placed.
template <int Dim>
std::array<std::int64_t, 3> placed_shift(const ContactPair& pair, const ImageShift& shift,
                                         const DisplacementTracker<Dim>& placing) {
  if (!placing.moved(pair.first) && !placing.moved(pair.second)) return {shift.x, shift.y, shift.z};
  const lattice::CellNumbers& first = placing.cells(pair.first);
  const lattice::CellNumbers& second = placing.cells(pair.second);
  return {std::int64_t{shift.x} - first[0] + second[0],
          std::int64_t{shift.y} - first[1] + second[1],
          std::int64_t{shift.z} - first[2] + second[2]};
}

}  // namespace

template <int Dim>
CandidatePairs<Dim>::CandidatePairs(base::MemoryMeter& memory)
    : found_(memory),
      layout_(memory),
      found_shifts_(base::make_array_for_overwrite<ShiftNumber>(memory, 0)),
      slots_(base::make_array_for_overwrite<kernels::QuantumSphere>(memory, 0)),
      survivors_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)) {}

/// The sum of its components bounds the length of a vector a, so shifts 1 to margin / sum along a
/// belong to candidates; all axes together give the least box of shifts that number_shifts() sees.
template <int Dim>
bool CandidatePairs<Dim>::too_many_shifts(const Domain& domain, double margin) noexcept {
  double count = 1.0;
  for (int axis = 0; axis < Dim; ++axis) {
    if (!domain.is_periodic(axis)) continue;
    const Domain::Vector& a = domain.vector(axis);
    count *= 1.0 + std::floor(margin / (std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2])));
  }
  return count > most_shifts;
}

template <int Dim>
base::PairSink& CandidatePairs<Dim>::start_anew(std::size_t elements, bool periodic) {
  periodic_ = periodic;
  size_ = 0;
  shift_list_.clear();
  found_.start_anew({.limit = most(elements), .shifts = periodic ? Shifts::stored : Shifts::none});
  return found_;
}

/// Writes the candidates in the order of space, so that the new slots follow that order too.
template <int Dim>
base::PairSink& CandidatePairs<Dim>::carry_over(std::span<const std::uint32_t> numbers,
                                                const DisplacementTracker<Dim>& placing,
                                                base::WorkCounter& work) {
  size_ = 0;
  found_.start_anew(
      {.limit = most(numbers.size()), .shifts = periodic_ ? Shifts::stored : Shifts::none});
  found_.expect_workers(1);
  base::ImagePairWriter writer(found_);
  const auto candidates = layout_.candidates();
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    work.did(2);
    const ContactPair before = layout_.pair_of(candidates[k]);
    ContactPair pair{numbers[before.first], numbers[before.second]};
    if (pair.first == elements::ElementIds::none || pair.second == elements::ElementIds::none)
      continue;
    ImageShift shift = periodic_ ? shift_list_[layout_.shifts()[k]] : ImageShift{};
    if (pair.first > pair.second) {
      std::swap(pair.first, pair.second);
      shift = base::opposite(shift);
    }
    writer.push(pair, periodic_ ? placing.shift_as_given(pair, shift) : shift);
  }
  writer.finish();
  return found_;
}

template <int Dim>
bool CandidatePairs<Dim>::finish(const ElementsNow<Dim>& now,
                                 const DisplacementTracker<Dim>& placing) {
  if (found_.size() > std::numeric_limits<std::uint32_t>::max()) return false;
  if (periodic_ && !number_shifts(placing, now.work)) return false;
  size_ = found_.size();
  layout_.use(kernels::order_kernels(now.simd));
  layout_.arrange(found_.pieces().pairs,
                  std::span<const ShiftNumber>(found_shifts_).first(periodic_ ? size_ : 0),
                  now.spheres.size(), now.workers, now.work);
  return true;
}

/// Numbers the shifts so that, for the same two elements, numbers ascend with shifts.
template <int Dim>
bool CandidatePairs<Dim>::number_shifts(const DisplacementTracker<Dim>& placing,
                                        base::WorkCounter& work) {
  const lists::FoundPieces pieces = found_.pieces();
  const auto for_each_shift = [&](auto&& body) {
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      work.did(1);
      work.in_pieces(0, pieces.pairs[p].size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          body(placed_shift(pieces.pairs[p][k], pieces.shifts[p][k], placing));
        }
      });
    }
  };
  ShiftRange range;
  for_each_shift([&](const auto& shift) { range.include(shift); });
  if (range.count() > most_shifts) return false;
  base::make_room(found_shifts_, found_.size());
  std::size_t next = 0;
  for_each_shift([&](const auto& shift) {
    found_shifts_[next++] = static_cast<ShiftNumber>(range.number_of(shift));
  });
  shift_list_.clear();
  for (std::int64_t x = range.lower[0]; x <= range.upper[0]; ++x) {
    for (std::int64_t y = range.lower[1]; y <= range.upper[1]; ++y) {
      for (std::int64_t z = range.lower[2]; z <= range.upper[2]; ++z) {
        shift_list_.push_back({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                               static_cast<std::int32_t>(z)});
      }
    }
  }
  return true;
}

template <int Dim>
void CandidatePairs<Dim>::fill_slots(const ElementsNow<Dim>& now,
                                     const DisplacementTracker<Dim>& placing) {
  quanta_ = quanta_of_placed(now, placing, shift_list_);
  const ElementIndex* const elements = layout_.elements();
  base::make_room(slots_, layout_.slot_count());
  base::for_each_share(now.workers, now.work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, now.workers, layout_.slot_count());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      const bool in_slots = elements != nullptr;
      quanta_.fill(placing.placed().data() + (in_slots ? 0 : begin),
                   in_slots ? elements + begin : nullptr,
                   std::span(slots_).subspan(begin, end - begin), now.simd);
    });
  });
}

/// Quanta must be known before the elements are. Where the skin covers them, each is at most
/// `allowed` and the largest radius from its anchor, and has grown by no more than `allowed`.
template <int Dim>
double CandidatePairs<Dim>::fill_slots_with(const ElementView& given, const CallNow& now,
                                            const DisplacementTracker<Dim>& then, double allowed) {
  if (!then.anchored_in_open_space(given.size(), now.domain) ||
      left_undecided_ > size_ / candidates_for_an_undecided) {
    return std::numeric_limits<double>::infinity();
  }
  const grid::Bounds<Dim>& anchors = then.anchor_bounds();
  const double radius_and_more = anchors.largest_radius + allowed;
  quanta_ = Quanta<Dim>(anchors.largest_half_width() + 3.0 * radius_and_more + now.margin,
                        anchors.middle());
  base::make_room(slots_, layout_.slot_count());
  return follow<Dim>({given,
                      then.anchors(),
                      quanta_,
                      {slots_.data(), layout_.slot_count()},
                      layout_.slots_of_elements()},
                     now, allowed);
}

/// Tests candidates whose order is canonical, and writes those that are contact pairs at once.
/// shift_at(k) is the image shift of candidate k.
template <int Dim>
template <class ShiftAt>
void CandidatePairs<Dim>::sift(const CandidateFilter<Dim>& test, std::size_t workers,
                               base::PairSink& sink, base::DetectionContext& context,
                               const ShiftAt& shift_at) {
  sink.expect_canonical_order();
  sink.expect_workers(workers);
  const std::size_t units = (size_ + candidates_of_run - 1) / candidates_of_run;
  std::atomic<std::uint64_t> exact_decisions = 0;
  std::atomic<std::uint64_t> left_undecided = 0;
  const auto sift_unit = [&](std::size_t worker, std::size_t unit, base::WorkCounter& work) {
    UndecidedCounts undecided;
    const std::size_t first = unit * candidates_of_run;
    const std::size_t count = std::min<std::size_t>(candidates_of_run, size_ - first);
    std::array<std::uint64_t, words_of_unit> survivors;
    const std::size_t words = (count + candidates_of_word - 1) / candidates_of_word;
    test.run(first / candidates_of_word, std::span(survivors).first(words), slots_.data(),
             undecided);
    CandidateWriter writer(sink, {worker, unit}, survivors.data());
    writer.write_in_order(layout_.candidates().subspan(first, count), test.kernels(),
                          [&](std::size_t k) { return shift_at(first + k); });
    writer.finish();
    exact_decisions += undecided.by_doubles;
    left_undecided += undecided.by_quanta;
    work.did(2 * count + steps_of_exact_decision * undecided.by_doubles);
  };
  base::for_each_index(workers, units, context.work, sift_unit);
  context.candidate_tests += size_;
  context.exact_decisions += exact_decisions;
  left_undecided_ = left_undecided;
}

template <int Dim>
void CandidatePairs<Dim>::test(const CandidateFilter<Dim>& test, std::size_t workers,
                               base::DetectionContext& context) {
  const std::size_t words = (size_ + candidates_of_word - 1) / candidates_of_word;
  const std::size_t units = (words + words_of_unit - 1) / words_of_unit;
  base::make_room(survivors_, words);
  std::atomic<std::uint64_t> exact_decisions = 0;
  std::atomic<std::uint64_t> left_undecided = 0;
  const auto test_unit = [&](std::size_t, std::size_t unit, base::WorkCounter& work) {
    UndecidedCounts undecided;
    const std::size_t first = unit * words_of_unit;
    const std::size_t count = std::min(words_of_unit, words - first);
    test.run(first, std::span(survivors_).subspan(first, count), slots_.data(), undecided);
    exact_decisions += undecided.by_doubles;
    left_undecided += undecided.by_quanta;
    work.did(candidates_of_word * count + steps_of_exact_decision * undecided.by_doubles);
  };
  base::for_each_index(workers, units, context.work, test_unit);
  context.candidate_tests += size_;
  context.exact_decisions += exact_decisions;
  left_undecided_ = left_undecided;
}

/// shift_at(k) is the image shift of candidate k in canonical order.
template <int Dim>
template <class ShiftAt>
void CandidatePairs<Dim>::write(std::size_t workers, base::PairSink& sink,
                                base::DetectionContext& context, const ShiftAt& shift_at) {
  sink.expect_canonical_order();
  sink.expect_workers(workers);
  const std::size_t units = (size_ + candidates_of_unit - 1) / candidates_of_unit;
  const auto write_unit = [&](std::size_t worker, std::size_t unit, base::WorkCounter& work) {
    work.did(candidates_of_unit);
    CandidateWriter writer(sink, {worker, unit}, survivors_.data());
    const std::size_t last = std::min<std::size_t>(size_, (unit + 1) * candidates_of_unit);
    for (std::size_t k = unit * candidates_of_unit; k < last; k += CandidateWriter::most) {
      writer.write(layout_.canonical(), k, std::min(CandidateWriter::most, last - k), shift_at);
    }
    writer.finish();
  };
  base::for_each_index(workers, units, context.work, write_unit);
}

template <int Dim>
void CandidatePairs<Dim>::deliver_contacts(const CallNow& now, const GivenSpheres<Dim>& spheres,
                                           const DisplacementTracker<Dim>& placing,
                                           base::PairSink& sink, base::DetectionContext& context) {
  const CandidateFilter<Dim> decide(now, spheres, placing,
                                    {layout_, shift_list_, periodic_ ? layout_.shifts() : nullptr},
                                    quanta_, images_);
  if (layout_.follows_space()) {
    const SlotPair* const pairs = layout_.candidates().data();
    return sift(decide, now.workers, sink, context, [&](std::size_t k) {
      return periodic_ ? placing.shift_as_given(layout_.pair_of(pairs[k]),
                                                shift_list_[layout_.shifts()[k]])
                       : ImageShift{};
    });
  }
  test(decide, now.workers, context);
  const CandidateLayout::Canonical canonical = layout_.canonical();
  write(now.workers, sink, context, [&](std::size_t k) {
    return periodic_ ? placing.shift_as_given(canonical.pairs[k], shift_list_[canonical.shifts[k]])
                     : ImageShift{};
  });
}

template class CandidatePairs<2>;
template class CandidatePairs<3>;

}  // namespace abut::skin
