#include "commands/command_explain.hpp"

#include "book_examples.hpp"
#include "talk.hpp"
#include "text/human_text.hpp"
#include "text/trace_text.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/trace.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

namespace abut::cli {
namespace {

constexpr std::size_t text_width = 100;
constexpr std::size_t most_elements = 1000;

/// Tells whether the mapping is shown: not where the arrays say the same, or no cell is looked at.
bool shows_mapping(Algorithm algorithm) {
  return algorithm != Algorithm::direct_check && algorithm != Algorithm::sorting_array;
}

/// A note on what the arrays alone do not say.
std::string reading_note(Algorithm algorithm) {
  if (algorithm != Algorithm::binary_tree) return "";
  return "Nodes are numbered as they are made; the children at the last level are positions of "
         "HEAD.";
}

std::string checks_text(std::size_t count, std::size_t checks) {
  return fmt::format("\n(N^2 - N) / 2 = ({} - {}) / 2 = {} checks\n", count * count, count, checks);
}

std::string walk(Algorithm algorithm, const trace::CellSystem& system,
                 const std::vector<RecordedStage>& stages, Numbering numbering,
                 const SearchChoice& searches) {
  std::string text;
  if (shows_mapping(algorithm)) {
    text += "\ncells of the elements\n" + mapping_text(system, numbering);
  }
  text += trace_text(stages, numbering, searches);
  if (algorithm == Algorithm::direct_check) {
    text += checks_text(system.cells.size(), all_candidates(stages).size());
  }
  return text + '\n' + pairs_text("candidate pair", all_candidates(stages), numbering);
}

/// Walks through what the book describes in 3D and draws in 2D only.
std::string walk_in_space(Algorithm algorithm, const BookExample& example) {
  if (!example.in_space) return "";
  const trace::CellSystem& system = *example.in_space;
  const std::vector<RecordedStage> stages = recorded(algorithm, system);
  return '\n' +
         wrapped(fmt::format("The same in 3D, which the book describes without an example: {} of "
                             "our own in {} x {} x {} cells.",
                             counted(system.cells.size(), "element"), system.cell_count[0],
                             system.cell_count[1], system.cell_count[2]),
                 text_width) +
         '\n' + walk(algorithm, system, stages, Numbering::from_one, {});
}

std::string explain_book(Algorithm algorithm) {
  const BookExample example = book_example(algorithm);
  const std::vector<RecordedStage> stages = recorded(algorithm, example.system);
  const AlgorithmInfo& row = info(algorithm);
  std::string text = fmt::format("{}: {}\n", row.name, row.idea);
  text +=
      wrapped(fmt::format("A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004, "
                          "p. {}; {}. Elements, cells and positions counted from 1 as in the "
                          "book, -1 is none.",
                          row.book_pages, example.figures),
              text_width) +
      '\n';
  for (const std::string& note : {reading_note(algorithm), example.note}) {
    if (!note.empty()) text += wrapped(note, text_width) + '\n';
  }
  return text +
         walk(algorithm, example.system, stages, Numbering::from_one, {example.searched_cell}) +
         book_supplement(algorithm, stages) + walk_in_space(algorithm, example);
}

std::string explain_file(const ExplainOptions& options, const io::Snapshot& snapshot) {
  if (snapshot.size() > most_elements) {
    throw Error(ErrorCode::limit_exceeded,
                fmt::format("{}: {} are too many to read through; explain takes at most {}",
                            snapshot.name(), elements_text(snapshot), grouped(most_elements)));
  }
  Options detection;
  detection.algorithm = options.algorithm;
  detection.margin = options.margin;
  const trace::CellSystem system = trace::integerise(snapshot.elements(), detection);
  const std::vector<RecordedStage> stages = recorded(options.algorithm, system);
  const PairList pairs = find_contact_pairs(snapshot.elements(), Domain::open(), detection);
  const AlgorithmInfo& row = info(options.algorithm);
  std::string text = fmt::format("{}: {}\n", row.name, row.idea);
  text += wrapped(fmt::format("{}: {}. Elements (rows of the file), cells and positions counted "
                              "from 0, -1 is none.",
                              snapshot.name(), elements_text(snapshot)),
                  text_width) +
          '\n';
  const std::string note = reading_note(options.algorithm);
  if (!note.empty()) text += wrapped(note, text_width) + '\n';
  return text + walk(options.algorithm, system, stages, Numbering::from_zero, {}) +
         pairs_text("contact pair", pairs.pairs(), Numbering::from_zero);
}

}  // namespace

void run(const ExplainOptions& options) {
  if (options.input.path.empty()) {
    write_out(explain_book(options.algorithm));
    return;
  }
  Console console(options.console);
  const io::Snapshot snapshot = load_snapshot(options.input, console);
  require_open(options.input.domain, snapshot, "explain");
  console.finish();
  write_out(explain_file(options, snapshot));
}

}  // namespace abut::cli
