#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/options.hpp>

#include <cstddef>

namespace abut::detect {

/// One call: which elements, where they live, and how their contacts are to be found. The caller's
/// objects outlive it.
struct DetectionRequest {
  const ElementView& elements;
  const Domain& domain;
  const Options& options;
  const ElementView* others = nullptr;  ///< the second set, where there are two

  /// Elements of all sets.
  [[nodiscard]] std::size_t size() const noexcept {
    return elements.size() + (others == nullptr ? 0 : others->size());
  }
};

}  // namespace abut::detect
