#pragma once

#include "base/memory_meter.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace abut::engine {

template <int Dim>
class CrowdedPart;
template <int Dim>
struct Workspace;

/// Arrays for a part of a set, and for the search of it. Those of the search hold the same for
/// parts of parts.
template <int Dim>
struct PartScratch {
  PartScratch(base::MemoryMeter& memory, std::size_t worker);
  ~PartScratch();
  PartScratch(const PartScratch&) = delete;
  PartScratch& operator=(const PartScratch&) = delete;

  std::unique_ptr<CrowdedPart<Dim>> part;
  std::unique_ptr<Workspace<Dim>> workspace;
};

/// The same of each worker, made when it is first asked for.
template <int Dim>
class PartScratches {
 public:
  explicit PartScratches(base::MemoryMeter& memory) : memory_(memory) {}

  /// Makes places for so many workers, while none works.
  void expect_workers(std::size_t workers) {
    if (scratches_.size() < workers) scratches_.resize(workers);
  }

  [[nodiscard]] PartScratch<Dim>& of(std::size_t place, std::size_t worker) {
    if (!scratches_[place]) {
      scratches_[place] = std::make_unique<PartScratch<Dim>>(memory_, worker);
    }
    return *scratches_[place];
  }

 private:
  base::MemoryMeter& memory_;
  std::vector<std::unique_ptr<PartScratch<Dim>>> scratches_;
};

}  // namespace abut::engine
