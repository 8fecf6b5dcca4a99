#include "commands/command_generate.hpp"

#include "interrupt.hpp"
#include "io/write/write_elements.hpp"
#include "load_snapshot.hpp"
#include "make_scene.hpp"
#include "options/output_option.hpp"
#include "scenes/scene.hpp"
#include "talk.hpp"
#include "text/human_text.hpp"
#include "text/json_text.hpp"
#include "text/text_table.hpp"

#include <fmt/format.h>

#include <string>

namespace abut::cli {
namespace {

std::string text_of_all() {
  TextTable table({Align::left, Align::left, Align::left});
  for (const scenes::SceneInfo& info : scenes::scenes()) {
    table.add_row(
        {std::string(info.name), fmt::format("{}D", info.dimensions), std::string(info.purpose)});
  }
  return table.text();
}

std::string json_of_all() {
  std::string rows;
  for (const scenes::SceneInfo& info : scenes::scenes()) {
    rows += fmt::format("{}\n  {{\"name\": {}, \"dimensions\": {}, \"purpose\": {}}}",
                        rows.empty() ? "" : ",", json_string(info.name), info.dimensions,
                        json_string(info.purpose));
  }
  return fmt::format("{{\"scenes\": [{}\n]}}\n", rows);
}

}  // namespace

void run(const GenerateOptions& options) {
  io::require_element_format(options.output, options.output_format);
  Console console(options.console);
  const io::Snapshot snapshot = console.while_shown("scene", options.count, [&] {
    return make_scene(options.scene, options.count, options.seed);
  });
  warn_unless_synced(
      io::write_elements(options.output, options.output_format, snapshot, console.progress()),
      options.output, console);
  console.finish();
  if (options.output == "-") return;
  console.note(fmt::format("{}: {} of {}; next: abut contacts {}", options.output,
                           elements_text(snapshot), snapshot.source, shell_quoted(options.output)));
}

void run(const SceneListOptions& options) {
  write_out(options.listing == Listing::json ? json_of_all() : text_of_all());
}

}  // namespace abut::cli
