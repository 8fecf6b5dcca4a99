#include "command_algorithms.hpp"

#include "json_text.hpp"
#include "talk.hpp"
#include "text_table.hpp"

#include <abut/algorithm.hpp>

#include <fmt/format.h>

#include <string>

namespace abut::cli {
namespace {

std::string dimensions_text(const AlgorithmInfo& info) {
  return info.min_dimensions == info.max_dimensions
             ? fmt::format("{}D", info.min_dimensions)
             : fmt::format("{}D, {}D", info.min_dimensions, info.max_dimensions);
}

std::string text_of_all() {
  std::string text;
  for (const AlgorithmInfo& info : algorithms()) {
    TextTable table({Align::left, Align::left});
    table.add_row({"time", fmt::format("~ {}", info.time)});
    table.add_row({"memory", fmt::format("{} integers", info.memory)});
    table.add_row({"carries", fmt::format("{}, {}", dimensions_text(info),
                                          info.periodic ? "open and periodic" : "open space")});
    table.add_row({"book", fmt::format("p. {}", info.book_pages)});
    text += fmt::format("{}: {}\n{}\n", info.name, info.idea, table.text("  "));
  }
  text +=
      "All give the same pairs. N elements; n_x, n_y, n_z cells along the axes. Book: A. Munjiza,\n"
      "The Combined Finite-Discrete Element Method, Wiley 2004.\n"
      "next: abut explain munjiza_nbs --book\n";
  return text;
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
