#include "benchmarks/device/list_bytes.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace abut::benchmarks {
namespace {

constexpr double sector = 32.0;
constexpr double coordinate = 8.0;  ///< of the caller's, as is a radius, a gap, an offset
constexpr double pair = 8.0;
constexpr double shift = 12.0;
constexpr double neighbor = 4.0;
// Of the engine. Keys are of 8 bytes where there are 2^32 cells and more.
constexpr double key = 4.0;
constexpr double number = 4.0;
constexpr double head = 4.0;
constexpr double size_in_units = 4.0;
constexpr double count_of_item = 4.0;

double columns_of(const DetectionSize& size) {
  return size.dimensions + (size.radii == RadiiGiven::once ? 0 : 1);
}

double entries_of(const DetectionSize& size) {
  if (size.form == ResultForm::count) return 0.0;
  const auto pairs = static_cast<double>(size.pairs);
  return size.form == ResultForm::full_list ? 2.0 * pairs : pairs;
}

bool is_neighbor_list(const DetectionSize& size) {
  return size.form == ResultForm::half_list || size.form == ResultForm::full_list;
}

/// Passes of a radix sort by numbers below about `most`. Cells are about as many as elements.
double passes_below(std::uint64_t most) {
  return static_cast<double>((std::bit_width(most) + 7) / 8);
}

/// From the caller's elements to counted pairs, for each element.
double search_bytes(const DetectionSize& size) {
  const double given = coordinate * columns_of(size);
  const double record = 4.0 * (size.dimensions + 1);
  const bool has_sizes = size.radii != RadiiGiven::once;
  const double own_size = has_sizes ? size_in_units : 0.0;
  const double look = record + own_size + key + head;

  const double check = given;
  const double place = given + record + key + number;
  const double sort = passes_below(size.elements) * 2.0 * (key + number) + key;
  const double gather = number + std::max(sector, record) + record;
  const double gather_sizes = has_sizes ? number + sector + size_in_units : 0.0;
  // Filled, written by slots, looked for where none was written: a head an element.
  const double directory = head + (key + head) + head;
  const double tests = key + head + 2.0 * count_of_item;
  const double count = look + 2.0 * count_of_item;
  const double scan = 2.0 * 2.0 * count_of_item;
  const double write = look + 2.0 * count_of_item;
  return check + place + sort + gather + gather_sizes + directory + count + tests + scan + write;
}

/// For each pair in doubt: the numbers of both elements are at random places of all columns.
double decision_bytes(const DetectionSize& size) {
  const double decide = pair + 2.0 * columns_of(size) * sector + pair;
  const double decide_open = pair;
  const double sum = size.form == ResultForm::count ? pair : 0.0;
  return pair + decide + decide_open + sum;
}

/// For each entry of a list: by first numbers, then row by row.
double order_bytes(const DetectionSize& size) {
  const double sort = passes_below(size.elements) * 2.0 * pair + pair;
  const double contacts_and_longest = pair;
  const double rows = 2.0 * pair;
  return sort + contacts_and_longest + rows;
}

/// For each entry of a list, once it is in order: its first element lies where that of the entry
/// before it lies, its second anywhere.
double gap_bytes(const DetectionSize& size) {
  const double measure = pair + columns_of(size) * (sector + coordinate) + coordinate;
  const double measure_open = coordinate;
  return measure + measure_open;
}

}  // namespace

DetectionSize size_of(const scenes::Scene& scene) {
  const auto [least, most] = std::minmax_element(scene.radius.begin(), scene.radius.end());
  const bool is_equal = scene.size() == 0 || *least == *most;
  return {.elements = scene.size(),
          .dimensions = scene.dimensions,
          .radii = is_equal ? RadiiGiven::equal_in_column : RadiiGiven::different};
}

double compulsory_bytes(const DetectionSize& size) {
  const auto n = static_cast<double>(size.elements);
  const double entries = entries_of(size);
  double bytes = n * coordinate * columns_of(size);
  bytes += is_neighbor_list(size) ? (n + 1.0) * coordinate + entries * neighbor : entries * pair;
  if (size.has_gaps) bytes += entries * coordinate;
  if (size.has_shifts) bytes += entries * shift;
  return bytes;
}

std::optional<double> moved_bytes(const DetectionSize& size) {
  if (size.is_periodic || size.radii == RadiiGiven::different) return std::nullopt;
  const auto n = static_cast<double>(size.elements);
  const auto pairs = static_cast<double>(size.pairs);
  const double entries = entries_of(size);
  double bytes =
      n * search_bytes(size) + static_cast<double>(size.exact_decisions) * decision_bytes(size);
  if (size.form == ResultForm::count) return bytes;
  // Pairs in doubt are written apart, and become contacts or not.
  bytes += std::max(pairs - static_cast<double>(size.exact_decisions), 0.0) * pair;
  if (size.form == ResultForm::full_list) bytes += pairs * 4.0 * pair;  // copied, and turned round
  bytes += entries * order_bytes(size);
  if (size.has_gaps) bytes += entries * gap_bytes(size);
  if (is_neighbor_list(size)) {
    bytes += (n + 1.0) * coordinate + entries * (pair + pair + neighbor);
  }
  if (size.has_shifts) bytes += entries * shift;  // zeros, in open space
  return bytes;
}

}  // namespace abut::benchmarks
