#pragma once

#include "base/detection_context.hpp"
#include "engine/search_set.hpp"
#include "engine/tile_searcher.hpp"
#include "engine/workspace.hpp"

#include <cstdint>

namespace abut::engine {

/// Tells whether a set must be packed first: a plane may suit so few elements, and how they are
/// searched must not depend on where they lie.
template <int Dim>
[[nodiscard]] bool must_be_packed(const SearchSet<Dim>& set, const SearchInput<Dim>& input);

/// Searches a set of few elements in a plane, by one worker.
template <int Dim>
class SearchInPlane {
 public:
  SearchInPlane(const SearchInput<Dim>& input, Workspace<Dim>& workspace,
                base::DetectionContext& context)
      : input_(input), workspace_(workspace), context_(context) {}

  /// Searches the set, as this unit of the search, if a plane suits it; returns whether it did.
  [[nodiscard]] bool search(const SearchSet<Dim>& set, std::uint64_t unit);

 private:
  const SearchInput<Dim>& input_;
  Workspace<Dim>& workspace_;
  base::DetectionContext& context_;
};

}  // namespace abut::engine
