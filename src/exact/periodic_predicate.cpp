// The slow path of the contract with a lattice: its stages, compiled once. Their story is in
// periodic_predicate-inl.hpp.

#include "exact/periodic_predicate-inl.hpp"

#include "exact/periodic_stages.hpp"

#include <optional>

namespace abut::exact {

template std::optional<bool> decide_if_difference_is_exact(const Sphere<2>&, const Sphere<2>&,
                                                           const LatticeSteps<2>&, double) noexcept;
template std::optional<bool> decide_if_difference_is_exact(const Sphere<3>&, const Sphere<3>&,
                                                           const LatticeSteps<3>&, double) noexcept;
template std::optional<bool> decide_in_double_double(const Sphere<2>&, const Sphere<2>&,
                                                     const LatticeSteps<2>&, double) noexcept;
template std::optional<bool> decide_in_double_double(const Sphere<3>&, const Sphere<3>&,
                                                     const LatticeSteps<3>&, double) noexcept;
template bool decide_accumulated(const Sphere<2>&, const Sphere<2>&, const LatticeSteps<2>&,
                                 double) noexcept;
template bool decide_accumulated(const Sphere<3>&, const Sphere<3>&, const LatticeSteps<3>&,
                                 double) noexcept;
template bool within_reach_exactly(const Sphere<2>&, const Sphere<2>&, const LatticeSteps<2>&,
                                   double) noexcept;
template bool within_reach_exactly(const Sphere<3>&, const Sphere<3>&, const LatticeSteps<3>&,
                                   double) noexcept;

}  // namespace abut::exact
