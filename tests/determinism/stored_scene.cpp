#include "stored_scene.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace abut::determinism {

StoredScene read_stored_scene(const std::filesystem::path& file) {
  std::ifstream stream(file);
  StoredScene scene;
  scene.name = file.stem().string();
  std::string word;
  std::string precision;
  std::size_t count = 0;
  // std::strtod reads hexadecimal numbers; the extraction of a double from a stream does not.
  const auto next_number = [&] {
    stream >> word;
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (!stream || *end != '\0') {
      throw std::runtime_error(file.string() + ": '" + word + "' is no number");
    }
    return number;
  };

  stream >> scene.dimensions >> precision;
  scene.precision = precision == "float32" ? Precision::float32 : Precision::float64;
  scene.margin = next_number();
  stream >> count;
  if (!stream || count == 0 || (scene.dimensions != 2 && scene.dimensions != 3)) {
    throw std::runtime_error(file.string() + ": the first line is not that of a scene");
  }
  const std::size_t numbers = count * static_cast<std::size_t>(scene.dimensions + 1);
  for (std::size_t k = 0; k < numbers; ++k) scene.numbers.push_back(next_number());
  if (stream >> word) throw std::runtime_error(file.string() + ": numbers after the last element");
  return scene;
}

}  // namespace abut::determinism
