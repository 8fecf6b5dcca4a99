#pragma once

#include <abut/trace.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace abut::cli {

struct RecordedArray {
  std::string book_symbol;
  std::string name;
  trace::Meaning meaning = trace::Meaning::element;
  trace::IndexedBy indexed_by = trace::IndexedBy::element;
  std::array<std::int32_t, 3> extent{};
  std::vector<std::int32_t> values;
};

/// The arrays that an algorithm showed between one stage and the next.
struct RecordedStage {
  std::string title;
  std::array<std::int32_t, 3> cell{};  ///< what it treats, -1 on axes without a number
  std::vector<RecordedArray> arrays;
  std::vector<trace::SearchStep> search_steps;
  std::vector<ContactPair> candidates;

  /// Tells whether it treats one cell, row or layer.
  [[nodiscard]] bool is_of_a_place() const { return cell[0] >= 0 || cell[1] >= 0 || cell[2] >= 0; }
};

/// Keeps all that an algorithm shows.
class TraceRecorder final : public trace::Sink {
 public:
  void stage(std::string_view title, std::array<std::int32_t, 3> cell) override;
  void array(const trace::Array& array) override;
  void search_step(const trace::SearchStep& step) override;
  void candidate_pair(ElementIndex first, ElementIndex second) override;

  std::vector<RecordedStage> stages;
};

/// Runs the algorithm on the cells.
[[nodiscard]] std::vector<RecordedStage> recorded(Algorithm algorithm,
                                                  const trace::CellSystem& system);

/// All candidate pairs of a run, ascending.
[[nodiscard]] std::vector<ContactPair> all_candidates(const std::vector<RecordedStage>& stages);

/// The last array of that symbol that was shown; null if there is none.
[[nodiscard]] const RecordedArray* last_array(const std::vector<RecordedStage>& stages,
                                              std::string_view book_symbol);

}  // namespace abut::cli
