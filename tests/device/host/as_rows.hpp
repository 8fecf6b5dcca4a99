#pragma once

#include "device/host/host_detection.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/pair_rule.hpp>

#include <cstddef>

namespace abut::testing {

/// Expects the pairs, shifts and numbers of `rows` from the stages of the device engine: with and
/// without shifts, with items in any order, on threads, and searches in parts. Returns how many
/// pairs there are.
std::size_t expect_as_rows(const ElementView& elements, const Domain& domain, double margin = 0.0,
                           const PairRule& rule = {});

/// The same of two sets.
std::size_t expect_as_rows(const ElementView& first, const ElementView& second,
                           const Domain& domain, double margin = 0.0, const PairRule& rule = {});

}  // namespace abut::testing
