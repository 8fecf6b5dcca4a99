#include "exact/periodic_box-inl.hpp"

namespace abut::exact {

template bool within_reach_exactly(const Box<2>&, const Box<2>&, const LatticeSteps<2>&,
                                   double) noexcept;
template bool within_reach_exactly(const Box<3>&, const Box<3>&, const LatticeSteps<3>&,
                                   double) noexcept;
template double gap(const Box<2>&, const Box<2>&, const ImageShift&, const Lattice&) noexcept;
template double gap(const Box<3>&, const Box<3>&, const ImageShift&, const Lattice&) noexcept;

}  // namespace abut::exact
