#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// Named deterministic inputs, shared by tests, benchmarks, the tool and the examples. Made with
/// random numbers of our own and only + - x / sqrt: the same bits on every machine.
namespace abut::scenes {

struct Scene {
  int dimensions = 3;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;  ///< empty in 2D
  std::vector<double> radius;

  [[nodiscard]] std::size_t size() const noexcept { return x.size(); }
};

struct SceneInfo {
  std::string_view name;
  int dimensions;
  std::string_view purpose;  ///< one line
  Scene (*make)(std::size_t count, std::uint64_t seed);
};

/// All scenes. A scene of `count` elements has exactly that many (0 included).
[[nodiscard]] std::span<const SceneInfo> scenes();

/// Throws abut::Error{wrong_usage} that says where the scenes are listed.
[[nodiscard]] const SceneInfo& scene_named(std::string_view name);

}  // namespace abut::scenes
