#include "exact/sphere_gap-inl.hpp"

namespace abut::exact {

template double gap(const Sphere<2>&, const Sphere<2>&) noexcept;
template double gap(const Sphere<3>&, const Sphere<3>&) noexcept;

}  // namespace abut::exact
