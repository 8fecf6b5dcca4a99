#pragma once

#include "console.hpp"
#include "element_sets.hpp"

#include <abut/exclusion_list.hpp>
#include <abut/group_table.hpp>
#include <abut/pair_rule.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace abut::cli {

/// The options of the command line about who may pair. The column of groups is one of the files'
/// own: `InputOptions::groups`.
struct RuleOptions {
  std::vector<std::array<std::uint32_t, 2>> denied;  ///< groups; none: each group with itself
  std::string exclude;                               ///< a file of pairs; empty: none
};

/// "A,B": two groups. Throws Error{wrong_usage}.
[[nodiscard]] std::array<std::uint32_t, 2> groups_denied(const std::string& text);

/// The options as they were given, for commands that are proposed.
[[nodiscard]] std::string as_given(const InputOptions& input, const RuleOptions& options);

/// A rule and the arrays that it is made of.
class LoadedRule {
 public:
  /// Reads the file of excluded pairs; notes groups that no element is of.
  LoadedRule(const InputOptions& input, const RuleOptions& options, const ElementSets& sets,
             Console& console);
  LoadedRule(const LoadedRule&) = delete;
  LoadedRule& operator=(const LoadedRule&) = delete;
  ~LoadedRule() = default;

  /// Valid as long as this object stays where it is, and the sets it was made for.
  [[nodiscard]] PairRule rule() const;

  /// "pairs of one mol, 12 pairs of bonds.csv"; empty where everybody may pair.
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  void load_groups(const InputOptions& input, const RuleOptions& options, const ElementSets& sets,
                   Console& console);
  void load_exclusions(const RuleOptions& options, const ElementSets& sets, Console& console);
  void add_to_text(const std::string& part);

  std::array<std::vector<std::uint32_t>, 2> numbered_;      ///< groups as the table numbers them
  std::array<std::span<const std::uint32_t>, 2> groups_{};  ///< these, or those of the sets
  std::optional<GroupTable> table_;
  std::optional<ExclusionList> exclusions_;
  std::string text_;
};

}  // namespace abut::cli
