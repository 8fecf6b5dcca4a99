#pragma once

#include "console.hpp"
#include "load_snapshot.hpp"
#include "options/device_option.hpp"
#include "options/rule_options.hpp"

#include <abut/neighbor_list.hpp>
#include <abut/options.hpp>

#include <string>

namespace abut::cli {

struct NeighborsOptions {
  InputOptions input;
  std::string against;  ///< the file of a second set; empty: one set
  RuleOptions rule;
  double cutoff = 0.0;
  NeighborListKind kind = NeighborListKind::half;
  Options detection;
  DeviceChoice device = {};  ///< where neighbors are searched
  ConsoleOptions console;
  std::string output;  ///< empty: neighbors are not written; "-" is standard output
};

/// Finds the neighbors of each element's center within a cutoff.
void run(const NeighborsOptions& options);

}  // namespace abut::cli
