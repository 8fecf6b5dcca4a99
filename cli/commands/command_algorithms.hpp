#pragma once

#include "listing.hpp"

namespace abut::cli {

struct AlgorithmsOptions {
  Listing listing = Listing::text;
};

/// Lists the algorithms that can be asked for.
void run(const AlgorithmsOptions& options);

}  // namespace abut::cli
