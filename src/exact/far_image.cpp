#include "exact/far_image-inl.hpp"

namespace abut::exact {

template bool far_image_within_reach(const Sphere<2>&, const Sphere<2>&, const FarShift&,
                                     const Lattice&, double) noexcept;
template bool far_image_within_reach(const Sphere<3>&, const Sphere<3>&, const FarShift&,
                                     const Lattice&, double) noexcept;
template bool far_image_within_reach(const Box<2>&, const Box<2>&, const FarShift&, const Lattice&,
                                     double) noexcept;
template bool far_image_within_reach(const Box<3>&, const Box<3>&, const FarShift&, const Lattice&,
                                     double) noexcept;

}  // namespace abut::exact
