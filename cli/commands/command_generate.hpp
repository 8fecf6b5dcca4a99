#pragma once

#include "console.hpp"
#include "listing.hpp"

#include <cstdint>
#include <string>

namespace abut::cli {

struct GenerateOptions {
  std::string scene;
  std::uint64_t count = 0;
  std::uint64_t seed = 1;
  std::string output = "-";
  std::string output_format;  ///< empty: by suffix
  ConsoleOptions console;
};

struct SceneListOptions {
  Listing listing = Listing::text;
};

/// Writes the elements of a scene.
void run(const GenerateOptions& options);

/// Lists the scenes.
void run(const SceneListOptions& options);

}  // namespace abut::cli
