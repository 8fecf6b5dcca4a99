#include "file_or_scene.hpp"

#include "make_scene.hpp"
#include "scenes/scene.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include <unistd.h>

namespace abut::cli {

io::Snapshot load_snapshot(const FileOrScene& source, Console& console) {
  const std::string& name = source.input.path;
  if (source.count.has_value()) {
    return console.while_shown("scene", *source.count,
                               [&] { return make_scene(name, *source.count, source.seed); });
  }
  const auto scenes = scenes::scenes();
  const bool is_scene = std::any_of(scenes.begin(), scenes.end(),
                                    [&name](const auto& scene) { return scene.name == name; });
  if (is_scene && access(name.c_str(), F_OK) != 0) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("{} is a scene: say how many elements with --count", name));
  }
  return load_snapshot(source.input, console);
}

}  // namespace abut::cli
