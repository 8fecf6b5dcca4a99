#pragma once

#include "base/detection_context.hpp"
#include "engine/search_set.hpp"
#include "engine/search_worker.hpp"
#include "engine/workspace.hpp"

#include <cstdint>

namespace abut::engine {

/// Tells whether a set must be packed first: a plane may suit so few elements, and how they are
/// searched must not depend on where they lie.
template <int Dim>
[[nodiscard]] bool must_be_packed(const SearchSet<Dim>& set, const SearchInput<Dim>& input);

/// Searches a set of few packed elements in a plane by the first worker, as this unit of the
/// search, if a plane suits it; returns whether it did.
template <int Dim>
[[nodiscard]] bool search_in_plane(const SearchSet<Dim>& set, const SearchInput<Dim>& input,
                                   Workspace<Dim>& workspace, base::DetectionContext& context,
                                   std::uint64_t unit);

}  // namespace abut::engine
