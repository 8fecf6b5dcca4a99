#include "engine/crowds/part_workspaces.hpp"

#include "engine/workspace.hpp"

namespace abut::engine {

template <int Dim>
PartWorkspaces<Dim>::PartWorkspaces(base::MemoryMeter& memory) : memory_(memory) {}

template <int Dim>
PartWorkspaces<Dim>::~PartWorkspaces() = default;

template <int Dim>
void PartWorkspaces<Dim>::expect_workers(std::size_t workers) {
  if (workspaces_.size() < workers) workspaces_.resize(workers);
}

template <int Dim>
Workspace<Dim>& PartWorkspaces<Dim>::of(std::size_t place, std::size_t worker) {
  if (!workspaces_[place]) workspaces_[place] = std::make_unique<Workspace<Dim>>(memory_, worker);
  return *workspaces_[place];
}

template class PartWorkspaces<2>;
template class PartWorkspaces<3>;

}  // namespace abut::engine
