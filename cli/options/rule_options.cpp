#include "options/rule_options.hpp"

#include "interrupt.hpp"
#include "io/quoted_text.hpp"
#include "io/read/read_pairs.hpp"
#include "options/argument.hpp"
#include "text/human_text.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace abut::cli {
namespace {

/// The groups that something is denied to, numbered from 0; all others are one group behind them.
class DeniedGroups {
 public:
  explicit DeniedGroups(const RuleOptions& options) {
    for (const auto& pair : options.denied) names_.insert(names_.end(), pair.begin(), pair.end());
    std::sort(names_.begin(), names_.end());
    names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
    met_.assign(names_.size(), 0);
  }

  [[nodiscard]] GroupTable table(const RuleOptions& options) const {
    GroupTable table(static_cast<std::uint32_t>(names_.size() + 1));
    for (const auto [a, b] : options.denied) table.deny(number_of(a), number_of(b));
    return table;
  }

  /// The numbers of groups, which are met now.
  [[nodiscard]] std::vector<std::uint32_t> numbers(std::span<const std::uint32_t> groups) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(groups.size());
    for (const std::uint32_t group : groups) {
      numbers.push_back(number_of(group));
      if (numbers.back() < met_.size()) met_[numbers.back()] = 1;
    }
    return numbers;
  }

  /// Names those that no element was of, "7 and 9"; empty where there are none.
  [[nodiscard]] std::string not_met() const {
    std::string text;
    for (std::size_t k = 0; k < names_.size(); ++k) {
      if (met_[k] == 0) text += (text.empty() ? "" : " and ") + std::to_string(names_[k]);
    }
    return text;
  }

 private:
  [[nodiscard]] std::uint32_t number_of(std::uint32_t group) const {
    const auto place = std::lower_bound(names_.begin(), names_.end(), group);
    const bool found = place != names_.end() && *place == group;
    return static_cast<std::uint32_t>((found ? place : names_.end()) - names_.begin());
  }

  std::vector<std::uint32_t> names_;
  std::vector<char> met_;
};

}  // namespace

std::array<std::uint32_t, 2> groups_denied(const std::string& text) {
  static constexpr std::string_view wanted = "two groups with a comma between them, such as 1,2";
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view first = std::string_view(text).substr(0, comma);
  const std::string_view second = std::string_view(text).substr(std::min(comma + 1, text.size()));
  const auto group = [&](std::string_view part) {
    std::uint32_t value = 0;
    const char* const end = part.data() + part.size();
    const auto result = std::from_chars(part.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end) reject("--deny", text, wanted);
    return value;
  };
  return {group(first), group(second)};
}

std::string as_given(const InputOptions& input, const RuleOptions& options) {
  std::string text;
  if (!input.groups.empty()) text += " --groups " + shell_quoted(input.groups);
  for (const auto& [a, b] : options.denied) text += fmt::format(" --deny {},{}", a, b);
  if (!options.exclude.empty()) text += " --exclude " + shell_quoted(options.exclude);
  return text;
}

LoadedRule::LoadedRule(const InputOptions& input, const RuleOptions& options,
                       const ElementSets& sets, Console& console) {
  if (!input.groups.empty()) load_groups(input, options, sets, console);
  if (!options.exclude.empty()) load_exclusions(options, sets, console);
}

void LoadedRule::load_groups(const InputOptions& input, const RuleOptions& options,
                             const ElementSets& sets, Console& console) {
  const std::string name = io::visible(input.groups);
  if (sets.first.groups.size() != sets.first.size()) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("--groups {}: a scene has no columns; take a file", name));
  }
  groups_[0] = sets.first.groups;
  if (sets.second) groups_[1] = sets.second->groups;
  if (options.denied.empty()) {
    add_to_text(fmt::format("pairs of one {}", name));
    return;
  }
  DeniedGroups denied(options);
  for (std::size_t set = 0; set < groups_.size(); ++set) {
    numbered_[set] = denied.numbers(groups_[set]);
    groups_[set] = numbered_[set];
  }
  table_ = denied.table(options);
  if (const std::string groups = denied.not_met(); !groups.empty()) {
    console.note(fmt::format("--deny: no element is of {} {}", name, groups));
  }
  constexpr std::size_t few = 3;
  if (options.denied.size() > few) {
    add_to_text(fmt::format("{} combinations of {}", options.denied.size(), name));
    return;
  }
  for (const auto& [a, b] : options.denied) {
    add_to_text(fmt::format("pairs of {} {} and {}", name, a, b));
  }
}

void LoadedRule::load_exclusions(const RuleOptions& options, const ElementSets& sets,
                                 Console& console) {
  const std::size_t first = sets.first.size();
  const std::size_t second = sets.partners().size();
  const std::vector<ContactPair> pairs =
      io::read_pairs(options.exclude, {first, second}, console.progress());
  exclusions_ = console.while_shown("exclude", pairs.size(), [&] {
    const InterruptsEndAtOnce at_once;
    return sets.are_two() ? ExclusionList(pairs, first, second) : ExclusionList(pairs, first);
  });
  const std::string source =
      options.exclude == "-" ? "standard input" : io::visible(options.exclude);
  add_to_text(fmt::format("{} of {}", counted(exclusions_->size(), "pair"), source));
}

void LoadedRule::add_to_text(const std::string& part) {
  if (!text_.empty()) text_ += ", ";
  text_ += part;
}

PairRule LoadedRule::rule() const {
  PairRule rule;
  rule.elements.groups = groups_[0];
  rule.others.groups = groups_[1];
  if (table_) rule.table = &*table_;
  if (exclusions_) rule.exclusions = &*exclusions_;
  return rule;
}

}  // namespace abut::cli
