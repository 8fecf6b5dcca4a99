#include "make_scene.hpp"

#include "interrupt.hpp"
#include "scenes/scene.hpp"
#include "text/human_text.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <utility>

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
              fmt::format("a scene of {} elements needs about {:.3g} bytes, more than the {:.3g} "
                          "bytes of this machine; ask for fewer",
                          count, needed, available));
}

}  // namespace

io::Snapshot make_scene(const std::string& name, std::uint64_t count, std::uint64_t seed) {
  const scenes::SceneInfo& info = scenes::scene_named(name);
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
