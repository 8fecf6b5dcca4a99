#include "engine/crowds/part_scratch.hpp"

#include "engine/crowds/crowded_part.hpp"
#include "engine/workspace.hpp"

namespace abut::engine {

template <int Dim>
PartScratch<Dim>::PartScratch(base::MemoryMeter& memory, std::size_t worker)
    : part(std::make_unique<CrowdedPart<Dim>>(memory)),
      workspace(std::make_unique<Workspace<Dim>>(memory, worker)) {}

template <int Dim>
PartScratch<Dim>::~PartScratch() = default;

template struct PartScratch<2>;
template struct PartScratch<3>;

}  // namespace abut::engine
