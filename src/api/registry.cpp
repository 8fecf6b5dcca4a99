// The table of algorithms. Conformance tests, benchmarks and the tool read it: a new algorithm is
// one file and one row here.

#include "api/registry.hpp"

#include "reference/algorithms.hpp"

#include <abut/error.hpp>

#include <array>
#include <string>

namespace abut::api {
namespace {

using namespace reference;

template <int Dim, class Test>
void direct(const grid::CellCoordinates<Dim>& cells, Test& test, base::DetectionContext& context) {
  direct_check(cells.element_count(), test, context);
}

constexpr std::array<RegistryRow, 5> table{{
    {{Algorithm::direct_check, "direct_check", "every element against every other", "N^2", "0",
      "77-80", 2, 3, false},
     direct<2, ContactTest<2>>,
     direct<3, ContactTest<3>>,
     direct<2, CandidateRecorder>,
     direct<3, CandidateRecorder>,
     nullptr,
     nullptr},
    {{Algorithm::binary_tree, "binary_tree", "occupied cells as leaves of a tree of halvings",
      "N log N", "at most 2 N b + 2 N (b levels)", "81-87", 2, 3, false},
     binary_tree<2, ContactTest<2>>,
     binary_tree<3, ContactTest<3>>,
     binary_tree<2, CandidateRecorder>,
     binary_tree<3, CandidateRecorder>,
     nullptr,
     nullptr},
    {{Algorithm::screening_array, "screening_array", "one list for each cell, empty or not",
      "N + cells", "cells + N", "89-94", 2, 3, false},
     screening_array<2, ContactTest<2>>,
     screening_array<3, ContactTest<3>>,
     screening_array<2, CandidateRecorder>,
     screening_array<3, CandidateRecorder>,
     screening_array_bytes<2>,
     screening_array_bytes<3>},
    {{Algorithm::sorting_array, "sorting_array", "elements sorted by cell, cells found by halving",
      "N log N", "3 N in 2D, 4 N in 3D", "94-102, 120", 2, 3, false},
     sorting_array<2, ContactTest<2>>,
     sorting_array<3, ContactTest<3>>,
     sorting_array<2, CandidateRecorder>,
     sorting_array<3, CandidateRecorder>,
     nullptr,
     nullptr},
    {{Algorithm::munjiza_nbs, "munjiza_nbs", "lists of rows, then of the cells of two rows only",
      "N", "2 N + n_y + 2 n_x in 2D, 3 N + n_z + 2 n_y + 2 n_x in 3D", "102-127", 2, 3, false},
     munjiza_nbs_2d<ContactTest<2>>,
     munjiza_nbs_3d<ContactTest<3>>,
     munjiza_nbs_2d<CandidateRecorder>,
     munjiza_nbs_3d<CandidateRecorder>,
     munjiza_nbs_bytes<2>,
     munjiza_nbs_bytes<3>},
}};

constexpr auto infos = [] {
  std::array<AlgorithmInfo, table.size()> result{};
  for (std::size_t k = 0; k < table.size(); ++k) result[k] = table[k].info;
  return result;
}();

}  // namespace

std::span<const RegistryRow> registry() {
  return table;
}

const RegistryRow& row_of(Algorithm algorithm) {
  for (const RegistryRow& row : table) {
    if (row.info.algorithm == algorithm) return row;
  }
  throw Error(ErrorCode::wrong_usage,
              "'auto' stands for a choice, not for one algorithm; name one");
}

}  // namespace abut::api

namespace abut {

std::span<const AlgorithmInfo> algorithms() {
  return api::infos;
}

const AlgorithmInfo& info(Algorithm algorithm) {
  return api::row_of(algorithm).info;
}

std::string_view name_of(Algorithm algorithm) {
  return algorithm == Algorithm::automatic ? "auto" : info(algorithm).name;
}

Algorithm algorithm_named(std::string_view name) {
  if (name == "auto") return Algorithm::automatic;
  std::string known = "auto";
  for (const AlgorithmInfo& row : algorithms()) {
    if (row.name == name) return row.algorithm;
    known += ", " + std::string(row.name);
  }
  throw Error(ErrorCode::wrong_usage,
              "no algorithm is called '" + std::string(name) + "'; there are " + known);
}

}  // namespace abut
