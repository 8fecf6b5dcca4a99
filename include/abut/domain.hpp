#pragma once

#include <abut/export.hpp>

namespace abut {

/// The space that the elements live in. Open: unbounded on every axis; the grid follows the
/// elements, so no bounds are asked for.
class Domain {
 public:
  [[nodiscard]] static constexpr Domain open() noexcept { return Domain{}; }

 private:
  constexpr Domain() noexcept = default;
};

}  // namespace abut
