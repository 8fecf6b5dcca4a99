#pragma once

#include "base/memory_meter.hpp"
#include "engine/crowds/crowded_part.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace abut::engine {

/// A part that waits.
template <int Dim>
struct WaitingPart {
  std::uint64_t unit;   ///< of the search in which it was found
  std::uint64_t found;  ///< ascends among those of a unit, which a single worker finds
  std::unique_ptr<CrowdedPart<Dim>> part;
};

/// Crowded parts that are searched when the search of the set has ended in which they were found.
/// They keep their memory from search to search.
template <int Dim>
class WaitingParts {
 public:
  explicit WaitingParts(base::MemoryMeter& memory) : memory_(memory) {}

  /// Forgets what a search left that failed.
  void start();

  /// A part whose memory is free, for so many elements or more. For any worker.
  [[nodiscard]] std::unique_ptr<CrowdedPart<Dim>> spare(std::size_t elements);
  /// Gives it back. For any worker.
  void give_back(std::unique_ptr<CrowdedPart<Dim>> part);

  /// Lets a part wait that was found in this unit. For any worker.
  void add(std::uint64_t unit, std::unique_ptr<CrowdedPart<Dim>> part);

  /// Those that wait, in the order in which a single worker would have found them.
  [[nodiscard]] std::vector<WaitingPart<Dim>> take();

 private:
  base::MemoryMeter& memory_;
  std::mutex mutex_;
  std::vector<WaitingPart<Dim>> waiting_;
  std::vector<std::unique_ptr<CrowdedPart<Dim>>> spares_;
};

}  // namespace abut::engine
