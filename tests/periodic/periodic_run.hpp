#pragma once

#include "engine/layers/layer_box_run.hpp"
#include "engine/random_spheres.hpp"
#include "engine/rows.hpp"
#include "periodic/periodic_search.hpp"
#include "scenes/box_scene.hpp"

#include <abut/domain.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// Templates are defined for two and three dimensions in periodic_run.cpp.

/// Searches of periodic domains by the engine itself, with limits of layers that no caller has.
namespace abut::testing {

template <int Dim>
struct SpheresInDomain {
  Spheres<Dim> spheres;
  Domain domain = Domain::open();
  double margin = 0.0;
};

template <int Dim>
struct BoxesInDomain {
  Boxes<Dim> boxes;
  Domain domain = Domain::open();
  double margin = 0.0;
};

template <int Dim>
[[nodiscard]] SpheresInDomain<Dim> spheres_in(const scenes::Scene& scene, const Domain& domain,
                                              double margin);
template <int Dim>
[[nodiscard]] BoxesInDomain<Dim> boxes_in(const scenes::BoxScene& scene, const Domain& domain,
                                          double margin);

/// What came of a search of locals and ghosts.
struct PeriodicRun {
  std::vector<FoundPair> pairs;  ///< as found
  std::uint64_t exact_decisions = 0;
  std::size_t most_in_layers = 0;  ///< elements of the largest set in layers
  std::size_t in_plane = 0;        ///< elements, if they were in a plane
  std::size_t clusters_moved = 0;
  std::size_t beside_layers = 0;
  std::size_t levels_of_sizes = 0;
  std::size_t crowded_layers = 0;
  std::size_t ghosts = 0;
};

/// Searches a packed copy. Nothing is returned where the reach is so long that `rows` has no grid.
template <int Dim>
[[nodiscard]] std::optional<PeriodicRun> run_periodic(const SpheresInDomain<Dim>& system,
                                                      const engine::RowsSettings& settings);
template <int Dim>
[[nodiscard]] std::optional<PeriodicRun> run_periodic(const BoxesInDomain<Dim>& system,
                                                      const engine::RowsSettings& settings);

/// The same where the spheres lie. Nothing is returned where they must be packed as well.
template <int Dim>
[[nodiscard]] std::optional<PeriodicRun> run_periodic_in_place(
    const SpheresInDomain<Dim>& system, const engine::RowsSettings& settings);

/// Returns pairs in canonical order. A pair that was found twice stands there twice.
[[nodiscard]] std::vector<FoundPair> in_order(std::vector<FoundPair> pairs);

/// The pairs of direct_check, which looks at each pair and image apart, in canonical order.
template <int Dim>
[[nodiscard]] std::vector<FoundPair> checked_directly(const SpheresInDomain<Dim>& system);
template <int Dim>
[[nodiscard]] std::vector<FoundPair> checked_directly(const BoxesInDomain<Dim>& system);

}  // namespace abut::testing
