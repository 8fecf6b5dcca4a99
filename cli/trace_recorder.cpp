#include "trace_recorder.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace abut::cli {

void TraceRecorder::stage(std::string_view title, std::array<std::int32_t, 3> cell) {
  RecordedStage next;
  next.title = title;
  next.cell = cell;
  stages.push_back(std::move(next));
}

void TraceRecorder::array(const trace::Array& array) {
  stages.back().arrays.push_back({std::string(array.book_symbol),
                                  std::string(array.name),
                                  array.meaning,
                                  array.indexed_by,
                                  array.extent,
                                  {array.values.begin(), array.values.end()}});
}

void TraceRecorder::search_step(const trace::SearchStep& step) {
  stages.back().search_steps.push_back(step);
}

void TraceRecorder::candidate_pair(ElementIndex first, ElementIndex second) {
  stages.back().candidates.push_back({first, second});
}

std::vector<RecordedStage> recorded(Algorithm algorithm, const trace::CellSystem& system) {
  TraceRecorder recorder;
  trace::run(algorithm, system, recorder);
  return std::move(recorder.stages);
}

std::vector<ContactPair> all_candidates(const std::vector<RecordedStage>& stages) {
  std::vector<ContactPair> pairs;
  for (const RecordedStage& stage : stages) {
    pairs.insert(pairs.end(), stage.candidates.begin(), stage.candidates.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

const RecordedArray* last_array(const std::vector<RecordedStage>& stages,
                                std::string_view book_symbol) {
  const RecordedArray* last = nullptr;
  for (const RecordedStage& stage : stages) {
    for (const RecordedArray& array : stage.arrays) {
      if (array.book_symbol == book_symbol) last = &array;
    }
  }
  return last;
}

}  // namespace abut::cli
