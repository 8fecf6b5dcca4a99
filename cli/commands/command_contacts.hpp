#pragma once

#include "console.hpp"
#include "load_snapshot.hpp"
#include "options/device_option.hpp"
#include "options/rule_options.hpp"

#include <abut/options.hpp>
#include <abut/quantity.hpp>

#include <string>

namespace abut::cli {

/// The report of `abut contacts` about the pairs, beside writing them.
enum class Report { summary, count, digest, json };

struct ContactsOptions {
  InputOptions input;
  std::string against;  ///< the file of a second set; empty: one set
  RuleOptions rule;
  Options detection;
  DeviceChoice device;
  ConsoleOptions console;
  std::string output;         ///< empty: pairs are not written; "-" is standard output
  std::string output_format;  ///< empty: by suffix
  Quantities with;            ///< what is written of a pair beside its gap
  bool ids = false;           ///< add the file's own ids to the output
  Report report = Report::summary;
};

/// Finds the contact pairs of a file.
void run(const ContactsOptions& options);

}  // namespace abut::cli
