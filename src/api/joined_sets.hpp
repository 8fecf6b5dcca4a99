#pragma once

#include "api/gathered_elements.hpp"
#include "base/array.hpp"
#include "base/detection_context.hpp"

#include <abut/element_view.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <span>

namespace abut::api {

/// Two sets of elements as one system: those of the first set, then those of the second. It keeps
/// its memory.
template <int Dim>
class JoinedSets {
 public:
  explicit JoinedSets(base::MemoryMeter& memory) : first_(memory), second_(memory) {}

  /// Reads both sets into `joined`. Throws as `gather` does, naming the set too.
  void gather(const ElementView& first, const ElementView& second, const GatherSettings& settings,
              GatheredElements<Dim>& joined, base::DetectionContext& context);

  /// How many elements of the first set are among those joined.
  [[nodiscard]] std::size_t first_count() const noexcept { return first_.spheres.size(); }

 private:
  GatheredElements<Dim> first_;
  GatheredElements<Dim> second_;
};

}  // namespace abut::api
