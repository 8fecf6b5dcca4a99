#pragma once

#include <abut/element_view.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace abut::determinism {

/// A scene as it lies in scenes/: hexadecimal numbers, so that reading them rounds nothing.
/// First line `dimensions precision margin count`, then one element a line, its radius last.
struct StoredScene {
  std::string name;
  int dimensions = 0;
  Precision precision = Precision::float64;
  double margin = 0.0;
  std::vector<double> numbers;  ///< element after element

  [[nodiscard]] std::size_t size() const {
    return numbers.size() / static_cast<std::size_t>(dimensions + 1);
  }
};

/// Throws std::runtime_error naming the file.
[[nodiscard]] StoredScene read_stored_scene(const std::filesystem::path& file);

/// The same numbers in the scene's own precision, and how the library sees them.
template <Real T>
struct SceneNumbers {
  explicit SceneNumbers(const StoredScene& scene) : dimensions(scene.dimensions) {
    for (const double number : scene.numbers) values.push_back(static_cast<T>(number));
  }

  [[nodiscard]] ElementView view() const {
    const auto width = static_cast<std::size_t>(dimensions + 1);
    const std::size_t size = values.size() / width;
    const auto column_of = [&](std::size_t k) {
      return Column<T>{values.data() + k, size, static_cast<std::ptrdiff_t>(width * sizeof(T))};
    };
    return dimensions == 2 ? discs(column_of(0), column_of(1), column_of(2))
                           : spheres(column_of(0), column_of(1), column_of(2), column_of(3));
  }

  int dimensions;
  std::vector<T> values;
};

}  // namespace abut::determinism
