#include "make_scene.hpp"

#include "interrupt.hpp"
#include "io/nearest_word.hpp"
#include "scenes/scene.hpp"
#include "text/human_text.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <unistd.h>

namespace abut::cli {
namespace {

/// A scene being made holds its columns once, and once more while a vector grows.
constexpr double bytes_per_element = 2 * 4 * sizeof(double);

void require_memory(std::uint64_t count) {
  const double available =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const double needed = bytes_per_element * static_cast<double>(count);
  if (needed <= available) return;
  throw Error(ErrorCode::limit_exceeded,
              fmt::format("a scene of {} needs about {} of memory, more than the {} "
                          "of this machine; ask for fewer",
                          counted(count, "element"),
                          byte_size(static_cast<std::uint64_t>(std::min(needed, 1e18))),
                          byte_size(static_cast<std::uint64_t>(available))));
}

const scenes::SceneInfo& scene_given(const std::string& name) {
  try {
    return scenes::scene_named(name);
  } catch (const Error& error) {
    std::vector<std::string> names;
    for (const scenes::SceneInfo& info : scenes::scenes()) names.emplace_back(info.name);
    throw Error(error.code(), error.what() + io::suggestion(name, names));
  }
}

}  // namespace

io::Snapshot make_scene(const std::string& name, std::uint64_t count, std::uint64_t seed) {
  const scenes::SceneInfo& info = scene_given(name);
  require_memory(count);
  const InterruptsEndAtOnce at_once;
  scenes::Scene scene = info.make(static_cast<std::size_t>(count), seed);
  io::Snapshot snapshot;
  snapshot.dimensions = scene.dimensions;
  snapshot.x = std::move(scene.x);
  snapshot.y = std::move(scene.y);
  snapshot.z = std::move(scene.z);
  snapshot.radius = std::move(scene.radius);
  snapshot.source = fmt::format("scene {}, seed {}", name, seed);
  snapshot.format = "scene";
  return snapshot;
}

}  // namespace abut::cli
