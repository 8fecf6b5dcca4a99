#pragma once

// Options that several commands share; only parse.cpp includes this.

#include "io/read/read_snapshot.hpp"
#include "options/argument.hpp"
#include "options/device_option.hpp"
#include "options/parse.hpp"
#include "options/rule_options.hpp"

#include <CLI/CLI.hpp>

#include <abut/algorithm.hpp>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace abut::cli {

/// An option whose text is handed to `use` after the whole line has been read.
template <class Use>
inline CLI::Option* add_value(CLI::App& app, const std::string& names, const std::string& type,
                              const std::string& description, Use use) {
  return app.add_option_function<std::string>(names, use, description)->type_name(type);
}

/// A flag that is only looked at.
inline CLI::Option* add_mark(CLI::App& app, const std::string& name,
                             const std::string& description) {
  return app.add_flag_function(
      name, [](std::int64_t) {}, description);
}

template <class Target, class Value>
inline CLI::Option* add_switch(CLI::App& app, const std::string& names,
                               const std::string& description, Target& target, Value value) {
  return app.add_flag_callback(
      names, [&target, value] { target = value; }, description);
}

inline void add_quiet(CLI::App& app, ConsoleOptions& console) {
  add_switch(app, "-q,--quiet", "say nothing but what was asked for, warnings and errors",
             console.quiet, true);
}

inline void add_console(CLI::App& app, ConsoleOptions& console) {
  add_quiet(app, console);
  add_value(app, "--progress", "auto|bar|log|none",
            "on standard error: a bar, or a line every 10 s; auto: a bar on a terminal",
            [&console](const std::string& text) {
              console.progress = choice<ProgressMode>("--progress", text,
                                                      {{"auto", ProgressMode::automatic},
                                                       {"bar", ProgressMode::bar},
                                                       {"log", ProgressMode::log},
                                                       {"none", ProgressMode::none}});
            });
}

inline void add_json(CLI::App& app, Listing& listing) {
  add_switch(app, "--json", "one JSON object", listing, Listing::json);
}

/// An option whose value is a name, which cannot be empty.
inline CLI::Option* add_name(CLI::App& app, const std::string& name, const std::string& type,
                             const std::string& description, std::string& target) {
  return add_value(app, name, type, description, [name, &target](const std::string& text) {
    if (text.empty()) reject(name, "''", "a name");
    target = text;
  });
}

/// The file that a result goes to.
inline CLI::Option* add_output(CLI::App& app, const std::string& type,
                               const std::string& description, std::string& target) {
  return add_value(app, "-o,--output", type, description, [&target](const std::string& text) {
    if (text.empty()) reject("-o", "''", "the name of a file, or - for standard output");
    target = text;
  });
}

/// The file that elements are read from.
inline CLI::Option* add_file(CLI::App& app, const std::string& name, const std::string& description,
                             std::string& target) {
  return app.add_option_function<std::string>(
      name,
      [name, &target](const std::string& text) {
        if (text.empty()) reject(name, "''", "a name, or - for standard input");
        target = text;
      },
      description);
}

/// The file of a second set of elements.
inline CLI::Option* add_against(CLI::App& app, std::string& against) {
  return add_name(
      app, "--against", "FILE2",
      "a second set: pairs are those of i in FILE and j in FILE2. --frame is then for files of "
      "several frames, --radius for files without radii; the box of one file holds for both",
      against);
}

/// Adds the options of the rule that says who may pair.
inline void add_rule(CLI::App& app, InputOptions& input, RuleOptions& rule) {
  CLI::Option* groups = add_name(
      app, "--groups", "NAME",
      "a column of whole numbers, such as mol; elements of one group do not pair", input.groups);
  app.add_option_function<std::vector<std::string>>(
         "--deny",
         [&rule](const std::vector<std::string>& pairs) {
           for (const std::string& pair : pairs) rule.denied.push_back(groups_denied(pair));
         },
         "instead, groups A and B do not pair, A,A for one with itself; may be repeated")
      ->type_name("A,B")
      ->allow_extra_args(false)
      ->needs(groups);
  add_name(app, "--exclude", "PAIRS",
           "a CSV file with columns i and j, as -o writes them: these do not pair", rule.exclude);
}

inline void add_columns(CLI::App& app, InputOptions& input) {
  add_value(app, "--columns", "NAMES",
            "names of the columns of a CSV table, such as x,y,z,radius, in place of a header line; "
            "others are ignored",
            [&input](const std::string& text) { input.columns = column_names("--columns", text); });
}

inline void add_frame_and_radius(CLI::App& app, InputOptions& input) {
  add_columns(app, input);
  add_value(app, "--frame", "K", "frame of FILE, from 0, negative from the end; default the last",
            [&input](const std::string& text) {
              input.frame = number<std::int64_t>("--frame", text, "a whole number");
            });
  add_value(app, "--radius", "R", "one radius for all elements, in place of those of FILE",
            [&input](const std::string& text) { input.radius = length("--radius", text); });
}

inline void add_domain(CLI::App& app, DomainOptions& domain) {
  const auto add = [&app, &domain](const std::string& name, const std::string& type,
                                   const std::string& description, auto use) {
    return add_value(app, name, type, description, [&domain, name, use](const std::string& text) {
      use(text);
      domain.as_given += fmt::format(" {} {}", name, text);
    });
  };
  add("--periodic", "AXES",
      "periodic axes, such as xy, or none for open space; default what FILE says, or all of a box "
      "that is given",
      [&domain](const std::string& text) { domain.periodic = axes_named(text); });
  CLI::Option* box =
      add("--box", "LX,LY[,LZ]", "lengths of the periodic box; default that of FILE",
          [&domain](const std::string& text) { domain.box = number_list("--box", text); });
  CLI::Option* lattice =
      add("--lattice", "A,B[,C]", "4 or 9 numbers: the vectors of the periodic cell one by one",
          [&domain](const std::string& text) { domain.lattice = number_list("--lattice", text); });
  box->excludes(lattice);
}

/// Options for commands that take open space only, of files that may say otherwise.
inline void add_open_space(CLI::App& app, DomainOptions& domain) {
  add_value(app, "--periodic", "none", "take the box of FILE as open space, which it must be here",
            [&domain](const std::string& text) {
              if (text != "none") reject("--periodic", text, "none: this is for open space only");
              domain.periodic = axes_named(text);
              domain.as_given += " --periodic none";
            });
}

inline void add_input_format(CLI::App& app, InputOptions& input) {
  add_name(
      app, "--format", "NAME",
      "format of FILE: csv, lammps_data, lammps_dump or xyz; default by suffix, then by content",
      input.format);
}

/// The options of a file that elements are read from.
inline void add_input(CLI::App& app, InputOptions& input) {
  add_input_format(app, input);
  add_frame_and_radius(app, input);
  add_domain(app, input.domain);
}

inline void add_file_or_scene(CLI::App& app, FileOrScene& source) {
  add_file(app, "FILE|SCENE", "elements to read; with --count a scene", source.input.path)
      ->required();
  add_value(app, "--count", "N", "number of elements of the scene",
            [&source](const std::string& text) { source.count = count("--count", text); });
  add_value(app, "--seed", "S", "seed of the scene; default 1", [&source](const std::string& text) {
    source.seed = number<std::uint64_t>("--seed", text, "a whole number");
  });
}

inline void add_algorithm_list(CLI::App& app, std::vector<Algorithm>& list,
                               const std::string& description) {
  add_value(app, "--algorithms", "A,B", description, [&list](const std::string& text) {
    for (const std::string& name : CLI::detail::split(text, ',')) {
      list.push_back(info(algorithm_given(name)).algorithm);
    }
  });
}

inline void add_device(CLI::App& app, DeviceChoice& device, const std::string& description) {
  add_value(app, "--device", "cpu|gpu|gpu:N", description,
            [&device](const std::string& text) { device = device_given(text); });
}

[[noreturn]] inline void reject_beside_device(std::string_view option) {
  throw Error(ErrorCode::wrong_usage,
              fmt::format("{} is not for devices; leave out {} or --device", option, option));
}

/// Throws Error{wrong_usage} if a device is asked for beside options that it has no use for, or
/// does not support yet.
inline void require_options_of_device(const CLI::App& app, const DeviceChoice& device,
                                      std::initializer_list<const char*> others) {
  if (!device) return;
  for (const char* const other : others) {
    if (app.get_option(other)->count() > 0) reject_beside_device(other);
  }
}

inline void add_margin(CLI::App& app, double& margin) {
  add_value(app, "--margin", "D", "pairs at most D apart count too; default 0",
            [&margin](const std::string& text) { margin = length("--margin", text); });
}

inline void add_max_memory(CLI::App& app, std::uint64_t& max_bytes) {
  add_value(app, "--max-memory", "BYTES", "fail rather than hold more; K, M, G for powers of 1024",
            [&max_bytes](const std::string& text) { max_bytes = bytes("--max-memory", text); });
}

}  // namespace abut::cli
