#pragma once

#include <cstddef>

namespace abut::base {

/// Storage for working arrays. Large blocks lie on huge pages where the system grants them: first
/// touch of 4 KiB pages otherwise costs as much as the detection itself (docs/adr/0003). Throws
/// std::bad_alloc.
[[nodiscard]] void* allocate_pages(std::size_t bytes);
void free_pages(void* block) noexcept;

}  // namespace abut::base
