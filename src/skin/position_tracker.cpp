#include "skin/position_tracker.hpp"

#include "base/asking_workers.hpp"
#include "elements/number_reader.hpp"
#include "kernels/displacement_kernels.hpp"

#include <abut/column.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <optional>

namespace abut::skin {
namespace {

using kernels::DisplacementBounds;
using kernels::DisplacementJob;

/// Relative error of a sum of two displacements, with a dozen roundings: at most 24 u.
constexpr double displacement_band = 0x1p-48;

/// Upper bound of what two displacements lose if squares of their components underflow, where the
/// length that is allowed is about 1.
constexpr double underflow = 0x1p-500;

template <Real T>
void read_column(const ElementView::Numbers& numbers, base::Array<double>& to,
                 base::WorkCounter& work) {
  const elements::NumberReader<T> reader(numbers);
  work.in_pieces(0, to.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) to[k] = reader[k];
  });
}

/// Numbers of the record that the coordinates of an element lie in, as the kernels read it; 1 for
/// columns.
std::optional<std::size_t> numbers_of_record(const ElementView& elements) {
  const int dimensions = elements.dimensions();
  if (elements.precision() != Precision::float64) return {};
  const std::byte* const first = elements.center(0).first;
  const std::ptrdiff_t stride = elements.center(0).stride_bytes;
  bool columns = true;
  bool records = true;
  for (int axis = 0; axis < dimensions; ++axis) {
    const ElementView::Numbers& numbers = elements.center(axis);
    if (reinterpret_cast<std::uintptr_t>(numbers.first) % alignof(double) != 0) return {};
    columns = columns && numbers.stride_bytes == sizeof(double);
    records = records && numbers.stride_bytes == stride &&
              numbers.first == first + static_cast<std::size_t>(axis) * sizeof(double);
  }
  if (columns) return 1;
  const auto size = static_cast<std::size_t>(stride) / sizeof(double);
  const auto least = static_cast<std::size_t>(dimensions);
  const bool known = stride > 0 && static_cast<std::size_t>(stride) % sizeof(double) == 0 &&
                     (size == least || size == least + 1);
  return records && known ? std::optional(size) : std::nullopt;
}

/// Compares positions now and then, part by part.
class DisplacementFinder {
 public:
  DisplacementFinder(const ElementView& elements, const std::array<base::Array<double>, 3>& then,
                     double scale, double largest_squared, Simd simd)
      : elements_(elements),
        then_(then),
        numbers_(numbers_of_record(elements)),
        scale_(scale),
        largest_squared_(largest_squared),
        kernels_(kernels::displacement_kernels(simd)) {}

  /// Elements [begin, end).
  void include(std::size_t begin, std::size_t end, DisplacementBounds& largest) const {
    if (numbers_) begin += kernels_.compare(job(begin, end), elements_.dimensions(), largest);
    elements_.precision() == Precision::float64 ? include_one_by_one<double>(begin, end, largest)
                                                : include_one_by_one<float>(begin, end, largest);
  }

 private:
  [[nodiscard]] DisplacementJob job(std::size_t begin, std::size_t end) const {
    DisplacementJob job{{}, *numbers_, {}, end - begin, scale_, largest_squared_};
    for (int axis = 0; axis < elements_.dimensions(); ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      job.now[a] =
          reinterpret_cast<const double*>(elements_.center(axis).first) + begin * *numbers_;
      job.then[a] = then_[a].data() + begin;
    }
    return job;
  }

  template <Real T>
  void include_one_by_one(std::size_t begin, std::size_t end, DisplacementBounds& largest) const {
    const int dimensions = elements_.dimensions();
    for (std::size_t k = begin; k < end; ++k) {
      double square = 0.0;
      for (int axis = 0; axis < dimensions; ++axis) {
        const double now = elements::NumberReader<T>(elements_.center(axis))[k];
        const double way = (now - then_[static_cast<std::size_t>(axis)][k]) * scale_;
        square += way * way;
      }
      largest.exceeded = largest.exceeded || !(square <= largest_squared_);
      largest.second = std::max(largest.second, std::min(largest.first, square));
      largest.first = std::max(largest.first, square);
    }
  }

  const ElementView& elements_;
  const std::array<base::Array<double>, 3>& then_;
  std::optional<std::size_t> numbers_;
  double scale_;
  double largest_squared_;
  kernels::DisplacementKernels kernels_;
};

void include(const DisplacementBounds& others, DisplacementBounds& largest) {
  largest.exceeded = largest.exceeded || others.exceeded;
  largest.second = std::max({largest.second, others.second, std::min(largest.first, others.first)});
  largest.first = std::max(largest.first, others.first);
}

}  // namespace

PositionTracker::PositionTracker(base::MemoryMeter& memory)
    : then_{base::make_array_for_overwrite<double>(memory, 0),
            base::make_array_for_overwrite<double>(memory, 0),
            base::make_array_for_overwrite<double>(memory, 0)} {}

void PositionTracker::anchor(const ElementView& elements, base::WorkCounter& work) {
  release();
  size_ = elements.size();
  for (int axis = 0; axis < elements.dimensions(); ++axis) {
    base::Array<double>& column = then_[static_cast<std::size_t>(axis)];
    base::resize_for_overwrite(column, size_);
    elements.precision() == Precision::float64
        ? read_column<double>(elements.center(axis), column, work)
        : read_column<float>(elements.center(axis), column, work);
  }
  dimensions_ = elements.dimensions();
}

bool PositionTracker::may_have_approached(const ElementView& elements, double allowed, Simd simd,
                                          std::size_t workers, base::WorkCounter& work) const {
  if (elements.dimensions() != dimensions_ || elements.size() != size_) return true;
  if (size_ == 0) return false;
  if (!(allowed > 0.0)) return true;
  // What is allowed becomes about 1, so that squares of what matters neither overflow nor
  // underflow.
  const double scale = std::ldexp(1.0, std::clamp(-std::ilogb(allowed), -1000, 1000));
  const double most = allowed * scale;
  const DisplacementFinder finder(elements, then_, scale, most * most, simd);
  DisplacementBounds largest;
  std::mutex mutex;
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, size_);
    DisplacementBounds own;
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      if (!own.exceeded) finder.include(begin, end, own);
    });
    const std::lock_guard lock(mutex);
    include(own, largest);
  });
  const double approach = std::sqrt(largest.first) + std::sqrt(largest.second);
  return largest.exceeded || !(approach * (1.0 + displacement_band) + underflow <= most);
}

}  // namespace abut::skin
