#pragma once

#include <abut/element_view.hpp>
#include <abut/group_table.hpp>
#include <abut/pair_rule.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::elements {

/// What errors call the properties of the elements of the first and the second set.
inline constexpr const char* first_set_of_rule = "rule.elements";
inline constexpr const char* second_set_of_rule = "rule.others";

/// Throws Error for a rule that does not fit its elements: arrays of other lengths, groups that the
/// table does not have, exclusions of more elements. `second` is null for one set.
void validate_rule(const PairRule& rule, const ElementView& first, const ElementView* second);

/// Throws what validate_rule throws, but looks at no entry of an array, which may lie elsewhere.
void validate_sizes_of_rule(const PairRule& rule, const ElementView& first,
                            const ElementView* second);

/// Throws Error{invalid_input}: the table has no such group.
[[noreturn]] void refuse_group(const std::string& set, std::size_t element, std::uint32_t group,
                               const GroupTable& table);

}  // namespace abut::elements
