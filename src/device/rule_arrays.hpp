#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/joined_columns.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/pair_rule.hpp"
#include "device/executor.hpp"
#include "elements/validate_rule.hpp"

#include <abut/pair.hpp>
#include <abut/pair_rule.hpp>

#include <cstdint>
#include <span>

namespace abut::device {

/// A rule in the memory of an executor. Its arrays of one number for each element lie there
/// already; the table and the exclusions, which the host has, are copied.
template <class E>
class RuleArrays {
 public:
  template <class Columns>
  RuleArrays(E& executor, const PairRule& rule, const Joined<Columns>& elements)
      : executor_(executor),
        given_table_(rule.table),
        first_count_(elements.first.count),
        count_(elements.count) {
    view_.first = traits_of(rule.elements);
    view_.second = traits_of(elements.is_of_two_sets ? rule.others : rule.elements);
    if (rule.table != nullptr) take(*rule.table);
    if (rule.exclusions != nullptr && rule.exclusions->size() > 0) take(*rule.exclusions);
  }

  /// Writes the number of the first element whose group the table does not have, or no_element, to
  /// memory of the device, if there is a table. Waits for nothing.
  void find_missing_group(std::uint32_t* number) {
    if (given_table_ == nullptr) return;
    executor_.reduce_into(number, count_, no_element, MissingGroup{view_, first_count_, no_element},
                          Smaller{});
  }

  /// Throws Error{invalid_input} that names that element: a group that is not there must not be
  /// looked up.
  void require_groups(std::uint32_t missing) {
    if (missing == no_element) return;
    const bool is_in_first = missing < first_count_;
    const std::uint32_t number = is_in_first ? missing : missing - first_count_;
    const RuleOfSet& traits = is_in_first ? view_.first : view_.second;
    std::uint32_t group = 0;
    executor_.copy_to_host(&group, traits.groups + number, 1);
    elements::refuse_group(is_in_first ? elements::first_set_of_rule : elements::second_set_of_rule,
                           number, group, *given_table_);
  }

  [[nodiscard]] const RuleView& view() const noexcept { return view_; }

 private:
  static RuleOfSet traits_of(const PairTraits& traits) {
    const auto array = [](const auto& numbers) {
      return numbers.empty() ? nullptr : numbers.data();
    };
    return {array(traits.groups), array(traits.categories), array(traits.accepts)};
  }

  template <class T>
  [[nodiscard]] Buffer<T, E> copied(std::span<const T> on_host) {
    Buffer<T, E> array(executor_, on_host.size());
    executor_.copy_to_device(array.data(), on_host.data(), on_host.size());
    return array;
  }

  void take(const GroupTable& table) {
    table_ = copied(table.words());
    view_.table = table_.data();
    view_.table_groups = table.size();
  }

  void take(const ExclusionList& exclusions) {
    offsets_ = copied(exclusions.offsets());
    partners_ = copied(exclusions.partners());
    view_.offsets = offsets_.data();
    view_.partners = partners_.data();
    view_.excluding_elements = exclusions.first_elements();
  }

  E& executor_;
  const GroupTable* given_table_;
  std::uint32_t first_count_;  ///< elements of the first set
  std::uint32_t count_;        ///< of both
  RuleView view_{};
  Buffer<std::uint64_t, E> table_;
  Buffer<std::uint64_t, E> offsets_;
  Buffer<ElementIndex, E> partners_;
};

}  // namespace abut::device
