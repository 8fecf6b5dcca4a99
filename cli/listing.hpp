#pragma once

namespace abut::cli {

/// Form of a listing: for people or for programs.
enum class Listing { text, json };

}  // namespace abut::cli
