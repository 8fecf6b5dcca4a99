#pragma once

#include "console.hpp"
#include "listing.hpp"
#include "load_snapshot.hpp"

namespace abut::cli {

struct InfoOptions {
  InputOptions input;
  ConsoleOptions console;
  Listing listing = Listing::text;
};

/// Says what is in a file.
void run(const InfoOptions& options);

}  // namespace abut::cli
