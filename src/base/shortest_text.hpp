#pragma once

#include <string>

namespace abut::base {

/// The shortest text that reads back as the same double, in no locale.
[[nodiscard]] std::string shortest_text(double value);

/// A count that may exceed 64 bits: digits up to 2^63, then "more than 9e18".
[[nodiscard]] std::string count_text(double count);

}  // namespace abut::base
