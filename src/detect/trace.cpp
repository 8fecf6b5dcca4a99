#include <abut/error.hpp>
#include <abut/trace.hpp>

#include "algorithms/registry.hpp"
#include "base/callers_exception.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "detect/validate_options.hpp"
#include "elements/gathered_elements.hpp"
#include "grid/integerise.hpp"
#include "reference/partition_sort.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace abut::trace {
namespace {

using base::DetectionContext;

/// Traces are for reading: a few hundred elements in a few thousand cells.
constexpr double most_traced_bytes = 1 << 24;
constexpr std::size_t most_traced_elements = 1 << 16;

/// Guards on both sides of an axis, and the neighbours of border cells, stay within 31 bits.
constexpr std::int32_t most_cells = std::numeric_limits<std::int32_t>::max() - 2;

template <int Dim>
CellSystem cells_of(const ElementView& elements, const Options& options) {
  DetectionContext context(detect::memory_bound(options), {});
  return base::reporting_lack_of_memory(context.memory, [&] {
    elements::GatheredElements<Dim> gathered(context.memory);
    elements::gather<Dim>(elements, {}, gathered, context);
    const auto cells =
        grid::integerise<Dim>(gathered.spheres, gathered.bounds, options.margin, context);
    CellSystem system;
    system.dimensions = Dim;
    system.cells.resize(elements.size());
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      system.cell_count[axis] = std::max(1, cells.cell_count[axis]);
      for (std::size_t k = 0; k < elements.size(); ++k) system.cells[k][axis] = cells.axis(axis)[k];
    }
    return system;
  });
}

void require_grid(const CellSystem& system) {
  if (system.dimensions != 2 && system.dimensions != 3) {
    throw Error(ErrorCode::wrong_usage,
                "dimensions = " + std::to_string(system.dimensions) + "; give 2 or 3");
  }
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(system.dimensions); ++axis) {
    if (system.cell_count[axis] >= 1 && system.cell_count[axis] <= most_cells) continue;
    throw Error(ErrorCode::wrong_usage, "cell_count[" + std::to_string(axis) +
                                            "] = " + std::to_string(system.cell_count[axis]) +
                                            "; give 1 to " + std::to_string(most_cells));
  }
}

template <int Dim>
void run(const registry::AlgorithmEntry& row, const CellSystem& system, Sink& sink) {
  DetectionContext context;
  context.trace = &sink;
  grid::CellCoordinates<Dim> cells(system.cells.size(), context.memory);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    cells.cell_count[axis] = system.cell_count[axis];
    cells.uncollapsed_cell_count[axis] = system.cell_count[axis];
    for (std::size_t k = 0; k < system.cells.size(); ++k) {
      const std::int32_t cell = system.cells[k][axis];
      if (cell < 0 || cell >= system.cell_count[axis]) {
        throw Error(ErrorCode::wrong_usage, "element " + std::to_string(k) + " is in cell " +
                                                std::to_string(cell) +
                                                " of an axis with cells 0 to " +
                                                std::to_string(system.cell_count[axis] - 1));
      }
      cells.axis(axis)[k] = cell;
    }
  }
  if (system.cells.size() > most_traced_elements ||
      registry::grid_bytes(row, cells) > most_traced_bytes) {
    throw Error(ErrorCode::limit_exceeded,
                std::to_string(system.cells.size()) +
                    " elements in this grid give arrays too long "
                    "to read; trace at most 65536 elements and 16 MiB of arrays");
  }
  reference::CandidateRecorder recorder(sink);
  row.entry_points.in<Dim>().trace(cells, recorder, context);
}

void run_checked(Algorithm algorithm, const CellSystem& system, Sink& sink) {
  const registry::AlgorithmEntry& row = registry::entry_of(algorithm);
  if (!row.info.traceable) {
    throw Error(ErrorCode::wrong_usage,
                std::string(row.info.name) +
                    " has no arrays to show; its page in docs/algorithms tells how it works");
  }
  require_grid(system);
  if (system.dimensions == 2) {
    run<2>(row, system, sink);
  } else {
    run<3>(row, system, sink);
  }
}

/// The caller's sink, whose lack of memory is its own.
class CallersSink final : public Sink {
 public:
  explicit CallersSink(Sink& sink) : sink_(sink) {}

  void stage(std::string_view title, std::array<std::int32_t, 3> cell) override {
    base::call_back([&] { sink_.stage(title, cell); });
  }
  void array(const Array& array) override {
    base::call_back([&] { sink_.array(array); });
  }
  void search_step(const SearchStep& step) override {
    base::call_back([&] { sink_.search_step(step); });
  }
  void candidate_pair(ElementIndex first, ElementIndex second) override {
    base::call_back([&] { sink_.candidate_pair(first, second); });
  }

 private:
  Sink& sink_;
};

}  // namespace

Sink::~Sink() = default;

CellSystem integerise(const ElementView& elements, const Options& options) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] { detect::validate(options, elements, Domain::open()); });
  return elements.dimensions() == 2 ? cells_of<2>(elements, options)
                                    : cells_of<3>(elements, options);
}

void run(Algorithm algorithm, const CellSystem& system, Sink& sink) {
  CallersSink callers(sink);
  try {
    base::reporting_lack_of_memory([&] { run_checked(algorithm, system, callers); });
  } catch (const base::CallersException& theirs) {
    std::rethrow_exception(theirs.exception);
  }
}

Partition first_partition(std::span<const std::int32_t> values) {
  return base::reporting_lack_of_memory([&] {
    Partition result{{values.begin(), values.end()}, values.size()};
    if (values.empty()) return result;
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    if (*lowest == *highest) return result;
    reference::CompanionArrays<1> arrays({std::span(result.values)});
    base::DetectionContext context;
    result.left_size = arrays.exchange(
        0, values.size(), 0, reference::partition_middle(*lowest, *highest), context.work);
    return result;
  });
}

}  // namespace abut::trace
