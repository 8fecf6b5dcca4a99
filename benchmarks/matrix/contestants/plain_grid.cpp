// The yardstick: a plain scalar grid in double precision, as good as such a thing gets. Counting
// sort by cell into packed records, then half of the neighbouring cells, in runs along x that lie
// in one piece. Its memory is kept, on huge pages.
//
// Complete: cells are a hair wider than the reach. Two touching elements are at most
// 1 / (1 + hair) cells apart on each axis; each of their cell coordinates is rounded by less than
// cells * 2^-51; so they lie in the same cell or in neighbours up to 10^9 cells an axis. The test
// is the plain one in double, which may err where two elements touch to within a few last places.

#include "benchmarks/matrix/contestant.hpp"
#include "benchmarks/matrix/huge_array.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

constexpr double hair = 1e-6;
/// More cells mean fewer tests, but more of them to clear, to sum up and to walk through.
constexpr double cells_per_element = 1.25;
constexpr double most_cells_on_an_axis = 1e9;

template <int Dim>
using Point = std::array<double, Dim>;

template <int Dim>
struct Record {
  Point<Dim> center;
  double radius;
};

template <int Dim>
std::array<const double*, Dim> columns_of(const Scene& scene) {
  if constexpr (Dim == 2) {
    return {scene.x.data(), scene.y.data()};
  } else {
    return {scene.x.data(), scene.y.data(), scene.z.data()};
  }
}

/// Smallest and largest number, in four strands so that they need not wait for one another.
std::pair<double, double> extent(const double* numbers, std::size_t count) {
  std::array<double, 4> low;
  std::array<double, 4> high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  const auto take = [&](std::size_t strand, double number) {
    low[strand] = number < low[strand] ? number : low[strand];
    high[strand] = number > high[strand] ? number : high[strand];
  };
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    for (std::size_t strand = 0; strand < 4; ++strand) take(strand, numbers[k + strand]);
  }
  for (; k < count; ++k) take(0, numbers[k]);
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

/// The place of the cells. Each axis has an empty cell before the first and behind the last, so
/// that the search need not look where it is.
template <int Dim>
struct Cells {
  Point<Dim> low{};
  double per_length = 1.0;
  std::array<std::size_t, Dim> count{};

  [[nodiscard]] std::size_t coordinate(double x, int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    return static_cast<std::size_t>(static_cast<std::uint32_t>((x - low[a]) * per_length)) + 1;
  }
  [[nodiscard]] std::size_t row_length() const { return count[0]; }
  [[nodiscard]] std::size_t rows() const { return count[1]; }
  [[nodiscard]] std::size_t layers() const {
    if constexpr (Dim == 3) return count[2];
    return 1;
  }
  [[nodiscard]] std::size_t all() const { return row_length() * rows() * layers(); }
};

/// As wide as the reach; wider where that would be more cells than a few per element.
template <int Dim>
Cells<Dim> fit_cells(const Scene& scene) {
  Cells<Dim> cells;
  Point<Dim> width{};
  double widest = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const auto [low, high] = extent(columns_of<Dim>(scene)[axis], scene.size());
    cells.low[axis] = low;
    width[axis] = high - low;
    widest = std::max(widest, width[axis]);
  }
  const double most = std::max(64.0, cells_per_element * static_cast<double>(scene.size()));
  const double reach = 2.0 * extent(scene.radius.data(), scene.size()).second;
  double size = std::max(reach * (1.0 + hair), widest / most_cells_on_an_axis);
  if (size <= 0.0) size = 1.0;
  for (;;) {
    double all = 1.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double count = std::floor(width[axis] / size) + 4.0;
      cells.count[axis] = static_cast<std::size_t>(count);
      all *= count;
    }
    if (all <= most || size > widest) break;
    size *= std::max(1.02, std::pow(all / most, 1.0 / Dim));
  }
  cells.per_length = 1.0 / size;
  return cells;
}

template <int Dim>
class PlainGrid {
 public:
  Answer run(const Scene& scene) {
    found_ = 0;
    tests_ = 0;
    if (scene.size() > 0) {
      cells_ = fit_cells<Dim>(scene);
      count_elements(scene);
      scatter(scene);
      search();
    }
    return {{pairs_.data(), found_}, found_};
  }

  [[nodiscard]] Counters counters() const {
    const std::size_t bytes =
        cell_of_.bytes() + first_.bytes() + records_.bytes() + numbers_.bytes() + pairs_.bytes();
    return {tests_, bytes, {}};
  }

 private:
  /// Afterwards first_[k] is the end of cell k in the order of cells.
  void count_elements(const Scene& scene) {
    const auto columns = columns_of<Dim>(scene);
    const std::size_t all = cells_.all();
    cell_of_.ensure(scene.size());
    first_.ensure(all + 1);
    std::uint32_t* const first = first_.data();
    std::fill_n(first, all + 1, 0U);
    const Cells<Dim> cells = cells_;
    for (std::size_t k = 0; k < scene.size(); ++k) {
      std::size_t cell = 0;
      for (int axis = Dim - 1; axis >= 0; --axis) {
        const auto a = static_cast<std::size_t>(axis);
        cell = cell * cells.count[a] + cells.coordinate(columns[a][k], axis);
      }
      cell_of_.data()[k] = static_cast<std::uint32_t>(cell);
      ++first[cell];
    }
    std::uint32_t sum = 0;
    for (std::size_t cell = 0; cell <= all; ++cell) first[cell] = sum += first[cell];
  }

  /// Afterwards first_[k] is the begin of cell k.
  void scatter(const Scene& scene) {
    const auto columns = columns_of<Dim>(scene);
    records_.ensure(scene.size());
    numbers_.ensure(scene.size());
    for (std::size_t k = 0; k < scene.size(); ++k) {
      const std::uint32_t place = --first_.data()[cell_of_.data()[k]];
      Record<Dim>& record = records_.data()[place];
      for (std::size_t axis = 0; axis < Dim; ++axis) record.center[axis] = columns[axis][k];
      record.radius = scene.radius[k];
      numbers_.data()[place] = static_cast<std::uint32_t>(k);
    }
  }

  /// How far before a cell the middle ones of the rows before it lie.
  [[nodiscard]] auto rows_before() const {
    const std::size_t row = cells_.row_length();
    if constexpr (Dim == 2) {
      return std::array{row};
    } else {
      const std::size_t layer = row * cells_.rows();
      return std::array{row, layer - row, layer, layer + row};
    }
  }

  void search() {
    const std::uint32_t* const first = first_.data();
    const std::size_t row_length = cells_.row_length();
    for (std::size_t layer = Dim - 2; layer < cells_.layers(); ++layer) {
      for (std::size_t y = 1; y + 1 < cells_.rows(); ++y) {
        const std::size_t row = (layer * cells_.rows() + y) * row_length;
        if (first[row] == first[row + row_length]) continue;
        for (std::size_t cell = row + 1; cell + 1 < row + row_length; ++cell) {
          if (first[cell] != first[cell + 1]) search_cell(cell);
        }
      }
    }
  }

  struct Run {
    std::uint32_t begin;
    std::uint32_t end;
  };

  void search_cell(std::size_t cell) {
    const std::uint32_t* const first = first_.data();
    const auto before = rows_before();
    std::array<Run, std::tuple_size_v<decltype(before)>> runs;
    const Run own{first[cell], first[cell + 1]};
    const std::uint32_t previous = first[cell - 1];
    std::size_t candidates = 0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      runs[k] = {first[cell - before[k] - 1], first[cell - before[k] + 2]};
      candidates += runs[k].end - runs[k].begin;
    }
    for (std::uint32_t p = own.begin; p < own.end; ++p) {
      const std::size_t tests = candidates + (p - previous);
      tests_ += tests;
      pairs_.grow(found_ + tests + 1, found_);
      std::size_t end = test(p, {previous, p}, found_);
      for (const Run& run : runs) end = test(p, run, end);
      name_pairs(p, end);
    }
  }

  /// Writes the place of each hit behind the pairs found, without a branch: one test in five
  /// succeeds, and none can tell which.
  std::size_t test(std::uint32_t p, Run run, std::size_t end) {
    const Record<Dim>* const records = records_.data();
    const Record<Dim> own = records[p];
    ContactPair* const pairs = pairs_.data();
    for (std::uint32_t q = run.begin; q < run.end; ++q) {
      double distance_squared = squared(own.center[0] - records[q].center[0]);
      for (std::size_t axis = 1; axis < Dim; ++axis) {
        distance_squared += squared(own.center[axis] - records[q].center[axis]);
      }
      const double reach = own.radius + records[q].radius;
      pairs[end].second = q;
      end += distance_squared <= reach * reach ? 1U : 0U;
    }
    return end;
  }

  static double squared(double x) { return x * x; }

  /// Turns places into the caller's numbers.
  void name_pairs(std::uint32_t p, std::size_t end) {
    const std::uint32_t* const numbers = numbers_.data();
    const std::uint32_t i = numbers[p];
    for (ContactPair* pair = pairs_.data() + found_; pair < pairs_.data() + end; ++pair) {
      const std::uint32_t j = numbers[pair->second];
      *pair = {std::min(i, j), std::max(i, j)};
    }
    found_ = end;
  }

  Cells<Dim> cells_;
  HugeArray<std::uint32_t> cell_of_;
  HugeArray<std::uint32_t> first_;
  HugeArray<Record<Dim>> records_;
  HugeArray<std::uint32_t> numbers_;
  HugeArray<ContactPair> pairs_;
  std::size_t found_ = 0;
  std::uint64_t tests_ = 0;
};

class PlainGridContestant final : public Contestant {
 public:
  Answer run(const Scene& scene) override {
    flat_ = scene.dimensions == 2;
    return flat_ ? discs_.run(scene) : spheres_.run(scene);
  }
  [[nodiscard]] Counters counters() const override {
    return flat_ ? discs_.counters() : spheres_.counters();
  }

 private:
  bool flat_ = false;
  PlainGrid<2> discs_;
  PlainGrid<3> spheres_;
};

}  // namespace

std::vector<Entry> enter_plain_grid() {
  Entry entry;
  entry.name = "plain_grid";
  entry.description = "a plain scalar counting-sort grid";
  entry.make = [] { return std::make_unique<PlainGridContestant>(); };
  return {entry};
}

}  // namespace abut::benchmarks
