// The command line, by CLI11. Only this file includes it, with common_options.hpp and
// help_text.hpp: it takes seconds to compile.

#include "options/parse.hpp"

#include "io/quoted_text.hpp"
#include "io/read/read_snapshot.hpp"
#include "io/suffix.hpp"
#include "options/argument.hpp"
#include "options/common_options.hpp"
#include "options/read_command_table.hpp"
#include "options/reject_unknown_words.hpp"
#include "text/help_text.hpp"

#include <CLI/CLI.hpp>

#include <abut/error.hpp>

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace abut::cli {
namespace {

/// The options of a subcommand live as long as the parse; the callback hands them over.
template <class Options>
std::shared_ptr<Options> hand_over(CLI::App& app, Command& command) {
  auto options = std::make_shared<Options>();
  app.callback([&command, options] { command = *options; });
  return options;
}

bool is_contact_format(std::string_view name) {
  return name == "csv" || name == "json" || name == "vtp";
}

/// Tells whether --format is that of the output. A file must hold what its name says: beside a name
/// of another format "csv" is that of the input, and the others are refused.
bool is_format_of_output(std::string_view format, const std::string& output) {
  if (output.empty() || !is_contact_format(format)) return false;
  const std::string suffix = output == "-" ? "" : io::suffix_of(output);
  if (suffix.empty() || !is_contact_format(suffix.substr(1)) || suffix.substr(1) == format) {
    return true;
  }
  if (format == "csv") return false;
  throw Error(
      ErrorCode::wrong_usage,
      fmt::format("--format {}: OUT is named {}; give it another name, or leave out --format",
                  format, suffix));
}

/// Adds the options of a search, whatever for.
void add_search(CLI::App& app, Options& detection) {
  add_value(app, "--algorithm", "ALGORITHM", "one of 'abut algorithms', or auto, the default",
            [&detection](const std::string& text) { detection.algorithm = algorithm_given(text); });
  add_value(app, "--threads", "N",
            "number of threads; 0, the default, as many as pay; the algorithms of the book use one",
            [&detection](const std::string& text) {
              detection.threads = thread_count("--threads", text);
            });
  add_value(app, "--simd", "auto|scalar|sse4|avx2|avx512|neon",
            "instruction set of rows; auto, the default, is the widest that this processor runs",
            [&detection](const std::string& text) { detection.simd = simd_given(text); });
}

void add_limits(CLI::App& app, Options& detection) {
  add_value(
      app, "--max-pairs", "M", "fail if there are more than M contact pairs",
      [&detection](const std::string& text) { detection.max_pairs = count("--max-pairs", text); });
  add_max_memory(app, detection.max_bytes);
}

void add_detection(CLI::App& app, Options& detection) {
  add_search(app, detection);
  add_value(app, "--order", "canonical|as_found",
            "pairs ascending by (i, j), the default, or as the algorithm meets them",
            [&detection](const std::string& text) {
              detection.order =
                  choice<Order>("--order", text,
                                {{"canonical", Order::canonical}, {"as_found", Order::as_found}});
            });
  add_margin(app, detection.margin);
  add_limits(app, detection);
}

void add_report(CLI::App& app, Report& report) {
  CLI::Option* count = add_switch(
      app, "--count", "print the number of contact pairs and nothing else", report, Report::count);
  CLI::Option* digest = add_switch(
      app, "--digest", "print the SHA-256 of the pairs in canonical order", report, Report::digest);
  CLI::Option* json = add_switch(app, "--json", "print one JSON object with counts and times",
                                 report, Report::json);
  count->excludes(digest)->excludes(json);
  digest->excludes(json);
}

/// The options of the file that pairs are written to; `format` may be that of the input as well.
void add_contacts_output(CLI::App& sub, const std::shared_ptr<ContactsOptions>& options,
                         std::string& format) {
  add_output(
      sub, "OUT",
      "write the pairs to a file .csv, .json or .vtp, CSV without a suffix; - is standard output",
      options->output);
  add_name(sub, "--format", "NAME",
           "of OUT if there is one: csv, json, vtp; of FILE: csv, lammps_data, lammps_dump, xyz; "
           "default by suffix, then by content",
           format);
  CLI::Option* ids = add_switch(sub, "--ids", "add the file's own ids to OUT", options->ids, true);
  ids->needs(sub.get_option("--output"));
  add_value(
      sub, "--with", "NAMES",
      "add these to the gap in OUT, with commas between them: normal, point, distance, vector",
      [options](const std::string& text) { options->with = quantities_named("--with", text); })
      ->needs(sub.get_option("--output"));
}

/// A search on a device takes no options that are the processor's, or not supported there yet.
template <class SearchOptions>
void require_search_of_device(const CLI::App& sub, const SearchOptions& options) {
  require_options_of_device(sub, options.device, {"--threads", "--simd"});
  const Algorithm algorithm = options.detection.algorithm;
  if (options.device && algorithm != Algorithm::automatic && algorithm != Algorithm::rows) {
    reject_beside_device("--algorithm " + std::string(name_of(algorithm)));
  }
}

void add_contacts(CLI::App& app, Command& command) {
  CLI::App& sub = *app.add_subcommand("contacts", "finds which elements of a file touch");
  sub.footer(
      "abut contacts packing.csv\n"
      "abut contacts pour.dump --frame 0 -o contacts.vtp\n"
      "abut contacts packing.csv -o - | head\n"
      "abut contacts probes.csv --against packing.csv --radius 0\n"
      "abut contacts chains.data --groups mol --exclude bonds.csv");
  auto options = hand_over<ContactsOptions>(sub, command);
  auto format = std::make_shared<std::string>();
  add_file(sub, "FILE", "elements to read; - is standard input", options->input.path)->required();
  add_against(sub, options->against);
  add_contacts_output(sub, options, *format);
  add_report(sub, options->report);
  add_detection(sub, options->detection);
  add_device(sub, options->device,
             "where pairs are searched: cpu, the default, or a GPU of this machine, by its number");
  add_rule(sub, options->input, options->rule);
  add_frame_and_radius(sub, options->input);
  add_domain(sub, options->input.domain);
  add_console(sub, options->console);
  sub.callback([&command, &sub, options, format] {
    const bool of_output = is_format_of_output(*format, options->output);
    (of_output ? options->output_format : options->input.format) = *format;
    require_search_of_device(sub, *options);
    command = *options;
  });
}

void add_neighbors(CLI::App& app, Command& command) {
  CLI::App& sub = *app.add_subcommand("neighbors", "finds the centers within a cutoff of each");
  sub.footer(
      "abut neighbors atoms.xyz --cutoff 3.5\n"
      "abut neighbors pour.dump --cutoff 2.5 --full -o neighbors.csv\n"
      "abut neighbors probes.csv --against atoms.xyz --cutoff 3.5");
  auto options = std::make_shared<NeighborsOptions>();
  add_file(sub, "FILE", "elements to read; - is standard input", options->input.path)->required();
  add_value(sub, "--cutoff", "C", "neighbors are centers at most C apart",
            [options](const std::string& text) { options->cutoff = length("--cutoff", text); })
      ->required();
  CLI::Option* against = add_against(sub, options->against);
  CLI::Option* full =
      add_switch(sub, "--full", "each pair from both sides", options->kind, NeighborListKind::full);
  add_switch(sub, "--half", "each pair once, at its smaller number: the default", options->kind,
             NeighborListKind::half)
      ->excludes(full)
      ->excludes(against);
  full->excludes(against);
  add_output(sub, "OUT",
             "write the neighbors as CSV, to a file .csv or without a suffix; - is standard output",
             options->output);
  add_search(sub, options->detection);
  add_limits(sub, options->detection);
  add_device(sub, options->device,
             "where neighbors are searched: cpu, the default, or a GPU, by its number");
  add_rule(sub, options->input, options->rule);
  add_input(sub, options->input);
  add_console(sub, options->console);
  sub.callback([&command, &sub, options] {
    require_search_of_device(sub, *options);
    command = *options;
  });
}

void add_info(CLI::App& app, Command& command) {
  CLI::App& sub = *app.add_subcommand("info", "says what is in a file");
  sub.footer("abut info packing.csv");
  auto options = hand_over<InfoOptions>(sub, command);
  add_file(sub, "FILE", "elements to read; - is standard input", options->input.path)->required();
  add_input_format(sub, options->input);
  add_json(sub, options->listing);
  add_frame_and_radius(sub, options->input);
  add_console(sub, options->console);
}

void add_generate(CLI::App& app, Command& command) {
  CLI::App& sub = *app.add_subcommand("generate", "writes the elements of a scene");
  sub.footer(
      "abut generate --list\n"
      "abut generate dense --count 100000 -o dense.csv");
  auto options = std::make_shared<GenerateOptions>();
  auto list = std::make_shared<SceneListOptions>();
  CLI::Option* scene = add_value(sub, "SCENE", "", "one of 'abut generate --list'",
                                 [options](const std::string& text) { options->scene = text; });
  CLI::Option* all = add_mark(sub, "--list", "list the scenes");
  CLI::Option* number_of_elements =
      add_value(sub, "--count", "N", "number of elements",
                [options](const std::string& text) { options->count = count("--count", text); });
  add_value(sub, "--seed", "S", "seed of the random numbers; default 1",
            [options](const std::string& text) {
              options->seed = number<std::uint64_t>("--seed", text, "a whole number");
            });
  add_output(sub, "FILE", "default - is standard output, as CSV", options->output);
  add_name(sub, "--format", "NAME", "csv, lammps_dump or xyz; default by suffix",
           options->output_format);
  add_switch(sub, "--json", "with --list: one JSON object", list->listing, Listing::json);
  add_console(sub, options->console);
  sub.callback([&command, options, list, scene, all, number_of_elements] {
    if (all->count() > 0) {
      command = *list;
      return;
    }
    if (scene->count() == 0 || number_of_elements->count() == 0) {
      throw Error(ErrorCode::wrong_usage,
                  "generate: name a scene and say how many elements with --count; "
                  "'abut generate --list' shows the scenes");
    }
    command = *options;
  });
}

void add_compare(CLI::App& app, Command& command) {
  CLI::App& sub =
      *app.add_subcommand("compare", "runs all algorithms on a file or scene and compares them");
  sub.footer(
      "abut compare packing.csv\n"
      "abut compare gas --count 20000 --algorithms munjiza_nbs,sorting_array");
  auto options = hand_over<CompareOptions>(sub, command);
  add_file_or_scene(sub, options->source);
  add_algorithm_list(sub, options->algorithms, "only these; default all that can");
  add_json(sub, options->listing);
  add_margin(sub, options->margin);
  add_max_memory(sub, options->max_bytes);
  add_input(sub, options->source.input);
  add_console(sub, options->console);
}

void add_bench(CLI::App& app, Command& command) {
  CLI::App& sub =
      *app.add_subcommand("bench", "measures algorithms on a file or scene, in a few seconds");
  sub.footer(
      "abut bench packing.csv\n"
      "abut bench dense --count 1000000 --algorithms rows --threads 1,2,4");
  auto options = hand_over<BenchOptions>(sub, command);
  add_file_or_scene(sub, options->source);
  add_algorithm_list(sub, options->algorithms,
                     "only these; default rows, and the others unless their first call takes "
                     "longer than 0.5 s");
  add_value(sub, "--threads", "N,M", "numbers of threads, 0 for as many as pay; default 1,0",
            [options](const std::string& text) {
              for (const std::string& one : CLI::detail::split(text, ',')) {
                options->threads.push_back(thread_count("--threads", one));
              }
            });
  add_device(sub, options->device, "measure a GPU besides, of the others rows unless asked for");
  add_value(sub, "--repetitions", "R", "calls after the first; default as many as 4 s in all allow",
            [options](const std::string& text) {
              options->repetitions = positive("--repetitions", text);
            });
  add_json(sub, options->listing);
  add_margin(sub, options->margin);
  add_max_memory(sub, options->max_bytes);
  add_rule(sub, options->source.input, options->rule);
  add_input(sub, options->source.input);
  add_console(sub, options->console);
  sub.callback([&command, options] { command = *options; });
}

void add_explain(CLI::App& app, Command& command) {
  CLI::App& sub = *app.add_subcommand("explain", "walks through an algorithm of the book");
  sub.footer(
      "abut explain munjiza_nbs --book\n"
      "abut explain sorting_array few_elements.csv");
  auto options = std::make_shared<ExplainOptions>();
  add_value(sub, "ALGORITHM", "NAME", "one of 'abut algorithms' with pages of the book",
            [options](const std::string& text) {
              options->algorithm = info(algorithm_given(text)).algorithm;
            })
      ->required();
  CLI::Option* file =
      add_file(sub, "FILE", "a small file; - is standard input", options->input.path);
  CLI::Option* book = add_mark(sub, "--book", "the book's own example, numbered as in the book");
  add_margin(sub, options->margin);
  add_input_format(sub, options->input);
  add_frame_and_radius(sub, options->input);
  add_open_space(sub, options->input.domain);
  add_console(sub, options->console);
  sub.callback([&command, options, file, book] {
    if ((file->count() > 0) == (book->count() > 0)) {
      throw Error(ErrorCode::wrong_usage,
                  "explain: give either FILE or --book, the book's own example");
    }
    command = *options;
  });
}

void add_algorithms(CLI::App& app, Command& command) {
  CLI::App& sub = *app.add_subcommand("algorithms", "lists the algorithms");
  sub.footer("abut algorithms");
  auto options = hand_over<AlgorithmsOptions>(sub, command);
  add_json(sub, options->listing);
}

void add_completion(CLI::App& app, Command& command) {
  CLI::App& sub = *app.add_subcommand(
      "completion", "prints what completes the command line in a shell, or the manual page");
  sub.footer(
      "abut completion bash > ~/.local/share/bash-completion/completions/abut\n"
      "abut completion man | man -l -");
  auto reader = std::make_shared<Reader>();
  add_value(sub, "bash|zsh|fish|man", "", "who reads it", [reader](const std::string& text) {
    *reader = choice<Reader>("completion", text,
                             {{"bash", Reader::bash},
                              {"zsh", Reader::zsh},
                              {"fish", Reader::fish},
                              {"man", Reader::man}});
  })->required();
  sub.callback([&app, &command, reader] {
    command = CompletionOptions{*reader, command_table(app)};
  });
}

void add_version(CLI::App& app, Command& command) {
  CLI::Option* version = add_mark(app, "--version", "print the version");
  CLI::Option* verbose = add_mark(app, "--verbose", "with --version: how abut was built");
  verbose->needs(version);
  app.callback([&app, &command, version, verbose] {
    if (!app.get_subcommands().empty()) return;
    if (version->count() == 0) {
      throw Error(ErrorCode::wrong_usage, "name a command; 'abut --help' lists them");
    }
    const auto detail = verbose->count() > 0 ? VersionDetail::build : VersionDetail::number;
    command = VersionOptions{detail};
  });
}

}  // namespace

Command parse(int argc, const char* const* argv) {
  Command command;
  CLI::App app("which discrete elements touch?", "abut");
  app.formatter_fn(help_text);
  app.set_help_flag("-h,--help", "show this text");
  app.footer(
      "abut contacts packing.csv\nabut generate dense --count 10000 | abut contacts -\nabut "
      "explain munjiza_nbs --book");
  app.require_subcommand(0, 1);
  add_contacts(app, command);
  add_neighbors(app, command);
  add_info(app, command);
  add_generate(app, command);
  add_compare(app, command);
  add_bench(app, command);
  add_explain(app, command);
  add_algorithms(app, command);
  add_completion(app, command);
  add_version(app, command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    // Who asks for help need not know the options.
    if (!app.remaining().empty()) reject_unknown_words(app);
    return HelpText{app.help()};
  } catch (const CLI::ParseError& error) {
    reject_unknown_words(app);
    throw Error(
        ErrorCode::wrong_usage,
        fmt::format("{}; see '{} --help'", io::visible(error.what()), full_name(chosen_app(app))));
  }
  return command;
}

}  // namespace abut::cli
