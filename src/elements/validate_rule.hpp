#pragma once

#include <abut/element_view.hpp>
#include <abut/pair_rule.hpp>

namespace abut::elements {

/// Throws Error for a rule that does not fit its elements: arrays of other lengths, groups that the
/// table does not have, exclusions of more elements. `second` is null for one set.
void validate_rule(const PairRule& rule, const ElementView& first, const ElementView* second);

}  // namespace abut::elements
