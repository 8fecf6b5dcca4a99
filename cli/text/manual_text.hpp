#pragma once

#include "options/command_table.hpp"

#include <string>

namespace abut::cli {

/// The manual page abut(1) in the macros of man(7), from the option tables.
[[nodiscard]] std::string manual_page(const CommandTable& table);

}  // namespace abut::cli
