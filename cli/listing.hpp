#pragma once

namespace abut::cli {

/// For people or for programs.
enum class Listing { text, json };

}  // namespace abut::cli
