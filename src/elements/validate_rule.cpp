#include "elements/validate_rule.hpp"

#include <abut/error.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace abut::elements {
namespace {

/// One set's traits, and what they are called in errors.
struct SetOfRule {
  std::string name;  ///< "rule.elements" or "rule.others"
  const PairTraits& traits;
  std::size_t elements;
};

void require_length(const SetOfRule& set, const char* array, std::size_t length) {
  if (length == set.elements) return;
  throw Error(ErrorCode::invalid_input, set.name + "." + array + " has " + std::to_string(length) +
                                            " numbers for " + std::to_string(set.elements) +
                                            " elements; give one for each, or none at all");
}

/// Throws unless each array that the rule uses has one number for each element.
void require_lengths(const SetOfRule& set, bool groups, bool categories) {
  if (groups) require_length(set, "groups", set.traits.groups.size());
  if (!categories) return;
  require_length(set, "categories", set.traits.categories.size());
  require_length(set, "accepts", set.traits.accepts.size());
}

void require_groups_in_table(const std::string& set, std::span<const std::uint32_t> groups,
                             const GroupTable& table) {
  for (std::size_t k = 0; k < groups.size(); ++k) {
    if (groups[k] >= table.size()) refuse_group(set, k, groups[k], table);
  }
}

void require_fit(const ExclusionList& exclusions, const ElementView& first,
                 const ElementView* second) {
  if (exclusions.size() == 0) return;
  if (exclusions.is_of_two_sets() != (second != nullptr)) {
    throw Error(ErrorCode::wrong_usage,
                std::string("exclusions ") +
                    (second == nullptr ? "of two sets for one set; make them with one number"
                                       : "of one set for two sets; make them with two numbers") +
                    " of elements");
  }
  const std::size_t second_elements = second == nullptr ? first.size() : second->size();
  if (exclusions.first_elements() <= first.size() &&
      exclusions.second_elements() <= second_elements) {
    return;
  }
  const std::string made_for = second == nullptr
                                   ? std::to_string(exclusions.first_elements())
                                   : std::to_string(exclusions.first_elements()) + " and " +
                                         std::to_string(exclusions.second_elements());
  const std::string there_are =
      second == nullptr ? std::to_string(first.size())
                        : std::to_string(first.size()) + " and " + std::to_string(second->size());
  throw Error(ErrorCode::invalid_input, "exclusions that were made for " + made_for +
                                            " elements; there are " + there_are +
                                            ": make them for these");
}

}  // namespace

void refuse_group(const std::string& set, std::size_t element, std::uint32_t group,
                  const GroupTable& table) {
  throw Error(ErrorCode::invalid_input,
              set + ".groups says that element " + std::to_string(element) + " is of group " +
                  std::to_string(group) + "; the table has " + std::to_string(table.size()) +
                  " groups, numbered from 0");
}

void validate_sizes_of_rule(const PairRule& rule, const ElementView& first,
                            const ElementView* second) {
  if (rule.is_empty()) return;
  const auto any = [&](const auto& member) {
    return !(rule.elements.*member).empty() || !(rule.others.*member).empty();
  };
  const bool groups = any(&PairTraits::groups) || rule.table != nullptr;
  const bool categories = any(&PairTraits::categories) || any(&PairTraits::accepts);
  const SetOfRule elements{first_set_of_rule, rule.elements, first.size()};
  const SetOfRule others{second_set_of_rule, rule.others, second == nullptr ? 0 : second->size()};
  require_lengths(elements, groups, categories);
  require_lengths(others, groups, categories);
  if (rule.exclusions != nullptr) require_fit(*rule.exclusions, first, second);
}

void validate_rule(const PairRule& rule, const ElementView& first, const ElementView* second) {
  validate_sizes_of_rule(rule, first, second);
  if (rule.table == nullptr) return;
  require_groups_in_table(first_set_of_rule, rule.elements.groups, *rule.table);
  require_groups_in_table(second_set_of_rule, rule.others.groups, *rule.table);
}

}  // namespace abut::elements
