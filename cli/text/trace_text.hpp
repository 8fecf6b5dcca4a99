#pragma once

#include "text/array_text.hpp"
#include "trace_recorder.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace abut::cli {

/// The binary searches of the sorting algorithm that are shown.
struct SearchChoice {
  std::optional<std::array<std::int32_t, 3>> only;  ///< none: every occupied cell, once
};

/// A run stage by stage: its arrays, its searches, the candidate pairs of each cell.
[[nodiscard]] std::string trace_text(std::span<const RecordedStage> stages, Numbering numbering,
                                     const SearchChoice& searches);

/// The cell of every element.
[[nodiscard]] std::string mapping_text(const trace::CellSystem& system, Numbering numbering);

/// "3 candidate pairs: 1-2 1-4 2-4", wrapped.
[[nodiscard]] std::string pairs_text(std::string_view kind, std::span<const ContactPair> pairs,
                                     Numbering numbering);

}  // namespace abut::cli
