#include "exact/periodic_gap-inl.hpp"

namespace abut::exact {

template double gap(const Sphere<2>&, const Sphere<2>&, const ImageShift&, const Lattice&) noexcept;
template double gap(const Sphere<3>&, const Sphere<3>&, const ImageShift&, const Lattice&) noexcept;

}  // namespace abut::exact
