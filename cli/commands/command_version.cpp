#include "commands/command_version.hpp"

#include "device_search.hpp"
#include "talk.hpp"
#include "text/text_table.hpp"

#include <abut/simd.hpp>
#include <abut/version.hpp>

#include <fmt/format.h>

#include <string>

namespace abut::cli {

namespace {

/// The instruction sets that can be asked for here.
std::string levels_text() {
  std::string text;
  for (const Simd level : simd_levels()) {
    if (!available(level)) continue;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name_of(level));
  }
  return text;
}

/// The devices that can be asked for here, or why there is none.
std::string devices_text() {
  std::string text;
  for (const device::DeviceInfo& device : device::devices()) {
    text += fmt::format("{}{}", text.empty() ? "" : "; ", device_text(device.number));
  }
  if (!text.empty()) return text;
  try {
    require_device(0);
  } catch (const Error& error) {
    const std::string sentence = error.what();
    const std::size_t reason = sentence.find(": ");
    if (reason != sentence.npos) {
      return "none" + sentence.substr(reason, sentence.find(';') - reason);
    }
  }
  return "none";
}

std::string build_text() {
  TextTable table({Align::left, Align::left});
  table.add_row({"Highway", ABUT_HIGHWAY_VERSION});
  table.add_row({"OpenMP", ABUT_OPENMP_VERSION});
  table.add_row({"SIMD levels here", levels_text()});
  table.add_row({"Devices here", devices_text()});
  return build_description() + '\n' + table.text("  ");
}

}  // namespace

void run(const VersionOptions& options) {
  write_out(options.detail == VersionDetail::build ? build_text()
                                                   : fmt::format("abut {}\n", version()));
}

}  // namespace abut::cli
