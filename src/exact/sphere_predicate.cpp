// The slow path of the contract (docs/contract.md): its stages, compiled once for each architecture
// that is to decide. Their story is in sphere_predicate-inl.hpp.

#include "exact/sphere_predicate-inl.hpp"

#include "exact/exact_stages.hpp"

#include <optional>

namespace abut::exact {

template std::optional<bool> decide_if_nothing_rounded(const Sphere<2>&, const Sphere<2>&,
                                                       double) noexcept;
template std::optional<bool> decide_if_nothing_rounded(const Sphere<3>&, const Sphere<3>&,
                                                       double) noexcept;
template std::optional<bool> decide_in_double_double(const Sphere<2>&, const Sphere<2>&,
                                                     double) noexcept;
template std::optional<bool> decide_in_double_double(const Sphere<3>&, const Sphere<3>&,
                                                     double) noexcept;
template std::optional<bool> decide_scaled(const Sphere<2>&, const Sphere<2>&, double) noexcept;
template std::optional<bool> decide_scaled(const Sphere<3>&, const Sphere<3>&, double) noexcept;
template bool decide_accumulated(const Sphere<2>&, const Sphere<2>&, double) noexcept;
template bool decide_accumulated(const Sphere<3>&, const Sphere<3>&, double) noexcept;
template bool within_reach_exactly<2>(const Sphere<2>&, const Sphere<2>&, double) noexcept;
template bool within_reach_exactly<3>(const Sphere<3>&, const Sphere<3>&, double) noexcept;

}  // namespace abut::exact
