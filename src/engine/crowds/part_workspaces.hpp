#pragma once

#include "base/memory_meter.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace abut::engine {

template <int Dim>
struct Workspace;

/// Arrays in which each worker searches parts of a set by itself, made when they are first asked
/// for. They hold the same for parts of parts.
template <int Dim>
class PartWorkspaces {
 public:
  explicit PartWorkspaces(base::MemoryMeter& memory);
  ~PartWorkspaces();
  PartWorkspaces(const PartWorkspaces&) = delete;
  PartWorkspaces& operator=(const PartWorkspaces&) = delete;

  /// Makes places for so many workers, while none works.
  void expect_workers(std::size_t workers);

  [[nodiscard]] Workspace<Dim>& of(std::size_t place, std::size_t worker);

 private:
  base::MemoryMeter& memory_;
  std::vector<std::unique_ptr<Workspace<Dim>>> workspaces_;
};

}  // namespace abut::engine
