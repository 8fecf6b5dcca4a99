#pragma once

#include "base/detection_context.hpp"
#include "reference/list_heads.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// The stages that the algorithms of the book show of themselves when a detection is traced;
/// otherwise one comparison with a null pointer.
namespace abut::reference {

using trace::IndexedBy;
using trace::Meaning;

inline constexpr std::int32_t any = -1;

inline void show_stage(base::DetectionContext& context, std::string_view title,
                       std::int32_t ix = any, std::int32_t iy = any, std::int32_t iz = any) {
  if (context.trace != nullptr) context.trace->stage(title, {ix, iy, iz});
}

/// One number per element: "next" arrays, integerised coordinates.
inline void show_list(base::DetectionContext& context, std::string_view book_symbol,
                      std::string_view name, std::span<const std::int32_t> values,
                      Meaning meaning = Meaning::element,
                      IndexedBy indexed_by = IndexedBy::element) {
  if (context.trace == nullptr) return;
  const auto size = static_cast<std::int32_t>(values.size());
  context.trace->array({book_symbol, name, meaning, indexed_by, {size, 1, 1}, values});
}

/// A row of heads without its guards, whether treated or not.
inline void show_heads(base::DetectionContext& context, std::string_view book_symbol,
                       std::string_view name, IndexedBy indexed_by,
                       std::span<const std::int32_t> heads) {
  if (context.trace == nullptr) return;
  std::vector<std::int32_t> first(heads.size());
  for (std::size_t k = 0; k < heads.size(); ++k) first[k] = first_of(heads[k]);
  const auto size = static_cast<std::int32_t>(first.size());
  context.trace->array({book_symbol, name, Meaning::element, indexed_by, {size, 1, 1}, first});
}

}  // namespace abut::reference
