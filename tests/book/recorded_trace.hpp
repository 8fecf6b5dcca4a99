#pragma once

#include <abut/trace.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {

/// An array as a trace showed it, counted from 0.
struct ShownArray {
  std::string symbol;
  std::string name;
  trace::Meaning meaning;
  std::array<std::int32_t, 3> extent;
  std::vector<std::int32_t> values;
};

/// What was shown between the begin of one stage and the next.
struct ShownStage {
  std::string title;
  std::array<std::int32_t, 3> cell;
  std::vector<ShownArray> arrays;
  std::vector<trace::SearchStep> search_steps;

  [[nodiscard]] const ShownArray& array(std::string_view symbol) const {
    for (const ShownArray& shown : arrays) {
      if (shown.symbol == symbol) return shown;
    }
    throw std::out_of_range("stage '" + title + "' shows no array " + std::string(symbol));
  }
};

/// Keeps all that an algorithm shows.
class RecordedTrace final : public trace::Sink {
 public:
  std::vector<ShownStage> stages;
  std::vector<ContactPair> candidates;  ///< in the order met

  void stage(std::string_view title, std::array<std::int32_t, 3> cell) override {
    stages.push_back({std::string(title), cell, {}, {}});
  }
  void array(const trace::Array& shown) override {
    stages.back().arrays.push_back({std::string(shown.book_symbol),
                                    std::string(shown.name),
                                    shown.meaning,
                                    shown.extent,
                                    {shown.values.begin(), shown.values.end()}});
  }
  void search_step(const trace::SearchStep& step) override {
    stages.back().search_steps.push_back(step);
  }
  void candidate_pair(ElementIndex first, ElementIndex second) override {
    candidates.push_back({first, second});
  }

  /// All stages whose title begins so.
  [[nodiscard]] std::vector<const ShownStage*> stages_called(std::string_view title) const {
    std::vector<const ShownStage*> found;
    for (const ShownStage& shown : stages) {
      if (shown.title.starts_with(title)) found.push_back(&shown);
    }
    return found;
  }

  /// The only stage whose title begins so.
  [[nodiscard]] const ShownStage& stage_called(std::string_view title) const {
    const auto found = stages_called(title);
    if (found.size() == 1) return *found.front();
    throw std::out_of_range(std::to_string(found.size()) + " stages '" + std::string(title) + "'");
  }

  /// The array shown last of all.
  [[nodiscard]] const ShownArray& last_array() const {
    for (auto shown = stages.rbegin(); shown != stages.rend(); ++shown) {
      if (!shown->arrays.empty()) return shown->arrays.back();
    }
    throw std::out_of_range("no array was shown");
  }

  /// With repetitions, ascending.
  [[nodiscard]] std::vector<ContactPair> sorted_candidates() const {
    auto sorted = candidates;
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }
};

[[nodiscard]] inline RecordedTrace record(Algorithm algorithm, const trace::CellSystem& system) {
  RecordedTrace recorded;
  trace::run(algorithm, system, recorded);
  return recorded;
}

}  // namespace abut::testing
