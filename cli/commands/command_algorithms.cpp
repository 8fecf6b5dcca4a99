#include "commands/command_algorithms.hpp"

#include "talk.hpp"
#include "text/json_text.hpp"
#include "text/text_table.hpp"

#include <abut/algorithm.hpp>

#include <fmt/format.h>

#include <string>
#include <vector>

namespace abut::cli {
namespace {

/// "2D 3D".
std::string dimensions_of(const AlgorithmInfo& info) {
  std::string text;
  for (int dimensions = info.min_dimensions; dimensions <= info.max_dimensions; ++dimensions) {
    text += fmt::format("{}{}D", text.empty() ? "" : " ", dimensions);
  }
  return text;
}

std::string text_of_all() {
  TextTable table(std::vector<Align>(5, Align::left));
  table.add_row({"algorithm", "time", "supports", "book", "idea"});
  TextTable memory(std::vector<Align>(3, Align::left));
  memory.add_row({"algorithm", "periodic", "memory in integers"});
  for (const AlgorithmInfo& info : algorithms()) {
    table.add_row({std::string(info.name), std::string(info.time), dimensions_of(info),
                   info.book_pages.empty() ? "-" : std::string(info.book_pages),
                   std::string(info.idea)});
    memory.add_row(
        {std::string(info.name), info.periodic ? "yes" : "no", std::string(info.memory)});
  }
  return table.text() + '\n' + memory.text() +
         "\nAll find the same pairs. N elements; n_x, n_y, n_z cells along the axes. Book: pages "
         "of\n"
         "A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004.\n"
         "In periodic domains N counts images near the faces, too, and rows takes 16 N + 32768\n"
         "more (boxes 24 N).\n"
         "next: abut explain munjiza_nbs --book\n";
}

std::string json_of_all() {
  std::string rows;
  for (const AlgorithmInfo& info : algorithms()) {
    rows += fmt::format(
        "{}\n  {{\"name\": {}, \"idea\": {}, \"time\": {}, \"memory_integers\": {}, "
        "\"min_dimensions\": {}, \"max_dimensions\": {}, \"periodic\": {}, \"book_pages\": {}}}",
        rows.empty() ? "" : ",", json_string(info.name), json_string(info.idea),
        json_string(info.time), json_string(info.memory), info.min_dimensions, info.max_dimensions,
        info.periodic, json_string(info.book_pages));
  }
  return fmt::format("{{\"algorithms\": [{}\n]}}\n", rows);
}

}  // namespace

void run(const AlgorithmsOptions& options) {
  write_out(options.listing == Listing::json ? json_of_all() : text_of_all());
}

}  // namespace abut::cli
