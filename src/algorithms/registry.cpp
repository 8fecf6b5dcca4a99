// The table of algorithms. Conformance tests, benchmarks and the tool read it: a new algorithm is
// one file and one row here.

#include "algorithms/registry.hpp"

#include "base/lack_of_memory.hpp"
#include "periodic/periodic_rows.hpp"
#include "reference/algorithms.hpp"
#include "reference/direct_check_images.hpp"

#include <abut/error.hpp>

#include <array>
#include <string>
#include <string_view>

namespace abut::registry {
namespace {

using namespace reference;

template <int Dim>
void direct_check_elements(const AlgorithmInput<Dim>& input, base::PairSink& sink,
                           base::DetectionContext& context) {
  sink.expect_workers(1);
  base::PairWriter pairs(sink);
  PairDecider<Dim> test(input.elements, input.settings.margin, pairs, context);
  direct_check(input.elements.size(), test, context);
  pairs.finish();
}

template <int Dim>
void direct_check_all_images(const AlgorithmInput<Dim>& input,
                             base::Array<exact::Sphere<Dim>>& spheres,
                             const exact::Lattice& lattice, base::PairSink& sink,
                             base::DetectionContext& context) {
  sink.expect_workers(1);
  base::ImagePairWriter pairs(sink);
  const exact::Elements<Dim> elements{spheres, input.elements.boxes};
  direct_check_images<Dim>(elements, lattice, input.settings.margin, pairs, context);
  pairs.finish();
}

template <int Dim>
void trace_direct_check(const grid::CellCoordinates<Dim>& cells, CandidateRecorder& recorder,
                        base::DetectionContext& context) {
  direct_check(cells.element_count(), recorder, context);
}

template <int Dim>
void rows(const AlgorithmInput<Dim>& input, base::PairSink& sink, base::DetectionContext& context) {
  engine::rows(input.elements, input.bounds, input.settings, input.workspace, sink, context);
}

template <int Dim>
constexpr EntryPoints<Dim> direct_check_entry{.on_elements = direct_check_elements<Dim>,
                                              .on_images = direct_check_all_images<Dim>,
                                              .trace = trace_direct_check<Dim>};

template <int Dim>
constexpr EntryPoints<Dim> binary_tree_entry{.on_cells = binary_tree<Dim, PairDecider<Dim>>,
                                             .trace = binary_tree<Dim, CandidateRecorder>};

template <int Dim>
constexpr EntryPoints<Dim> screening_array_entry{.on_cells = screening_array<Dim, PairDecider<Dim>>,
                                                 .trace = screening_array<Dim, CandidateRecorder>,
                                                 .grid_bytes = screening_array_bytes<Dim>};

template <int Dim>
constexpr EntryPoints<Dim> sorting_array_entry{.on_cells = sorting_array<Dim, PairDecider<Dim>>,
                                               .trace = sorting_array<Dim, CandidateRecorder>};

constexpr EntryPoints<2> munjiza_nbs_2d_entry{.on_cells = munjiza_nbs_2d<PairDecider<2>>,
                                              .trace = munjiza_nbs_2d<CandidateRecorder>,
                                              .grid_bytes = munjiza_nbs_bytes<2>};

constexpr EntryPoints<3> munjiza_nbs_3d_entry{.on_cells = munjiza_nbs_3d<PairDecider<3>>,
                                              .trace = munjiza_nbs_3d<CandidateRecorder>,
                                              .grid_bytes = munjiza_nbs_bytes<3>};

template <int Dim>
void periodic_rows(const AlgorithmInput<Dim>& input, base::Array<exact::Sphere<Dim>>& spheres,
                   const exact::Lattice& lattice, base::PairSink& sink,
                   base::DetectionContext& context) {
  const bool found = periodic::periodic_rows<Dim>(
      spheres, {input.elements.boxes, input.bounds, lattice, input.settings}, input.workspace,
      input.periodic_workspace, sink, context);
  if (!found) direct_check_all_images<Dim>(input, spheres, lattice, sink, context);
}

template <int Dim>
constexpr EntryPoints<Dim> rows_entry{.on_elements = rows<Dim>, .on_images = periodic_rows<Dim>};

/// A row of the table: what the entry points support stands in the facts.
constexpr AlgorithmEntry entry(AlgorithmInfo info, const EntryPoints<2>& in_2d,
                               const EntryPoints<3>& in_3d) {
  info.periodic = in_2d.on_images != nullptr && in_3d.on_images != nullptr;
  info.traceable = in_2d.trace != nullptr && in_3d.trace != nullptr;
  return {info, {in_2d, in_3d}};
}

constexpr std::array table{
    entry({Algorithm::direct_check, "direct_check", "every element against every other", "N^2", "0",
           "77-80"},
          direct_check_entry<2>, direct_check_entry<3>),
    entry({Algorithm::binary_tree, "binary_tree", "occupied cells as leaves of a tree of halvings",
           "N log N", "at most 2 N b + 2 N (b levels)", "81-87"},
          binary_tree_entry<2>, binary_tree_entry<3>),
    entry({Algorithm::screening_array, "screening_array", "one list for each cell, empty or not",
           "N + cells", "cells + N", "89-94"},
          screening_array_entry<2>, screening_array_entry<3>),
    entry({Algorithm::sorting_array, "sorting_array",
           "elements sorted by cell, cells found by halving", "N log N", "3 N in 2D, 4 N in 3D",
           "94-102, 120"},
          sorting_array_entry<2>, sorting_array_entry<3>),
    entry(
        {Algorithm::munjiza_nbs, "munjiza_nbs", "lists of rows, then of the cells of two rows only",
         "N", "2 N + n_y + 2 n_x in 2D, 3 N + n_z + 2 n_y + 2 n_x in 3D", "102-127"},
        munjiza_nbs_2d_entry, munjiza_nbs_3d_entry),
    entry({Algorithm::rows, "rows", "rows of cells in layers or tiles, contiguous", "N",
           "at most 32 N + 32768 (boxes 36 N), and 131072 a further thread", ""},
          rows_entry<2>, rows_entry<3>),
};

constexpr auto infos = [] {
  std::array<AlgorithmInfo, table.size()> result{};
  for (std::size_t k = 0; k < table.size(); ++k) result[k] = table[k].info;
  return result;
}();

}  // namespace

std::span<const AlgorithmEntry> registry() {
  return table;
}

const AlgorithmEntry& entry_of(Algorithm algorithm) {
  for (const AlgorithmEntry& row : table) {
    if (row.info.algorithm == algorithm) return row;
  }
  throw Error(ErrorCode::wrong_usage,
              "'auto' stands for a choice, not for one algorithm; name one");
}

}  // namespace abut::registry

namespace abut {

std::span<const AlgorithmInfo> algorithms() {
  return registry::infos;
}

const AlgorithmInfo& info(Algorithm algorithm) {
  return base::reporting_lack_of_memory(
      [&]() -> const AlgorithmInfo& { return registry::entry_of(algorithm).info; });
}

std::string_view name_of(Algorithm algorithm) {
  return algorithm == Algorithm::automatic ? "auto" : info(algorithm).name;
}

Algorithm algorithm_named(std::string_view name) {
  return base::reporting_lack_of_memory([&] {
    if (name == "auto") return Algorithm::automatic;
    std::string known = "auto";
    for (const AlgorithmInfo& row : algorithms()) {
      if (row.name == name) return row.algorithm;
      known += ", " + std::string(row.name);
    }
    throw Error(ErrorCode::wrong_usage,
                "no algorithm is called '" + std::string(name) + "'; there are " + known);
  });
}

}  // namespace abut
