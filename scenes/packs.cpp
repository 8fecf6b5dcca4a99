#include "scenes/packs.hpp"

#include "scenes/families.hpp"

#include <cstdint>

namespace abut::scenes {
namespace {

constexpr double default_spacing = 2.0;

/// Between columns two spacings in turn.
struct Spacings {
  double odd_x;
  double even_x;
  double y;
};

/// The first `count` discs of a pack, row by row.
Scene pack(std::size_t count, std::size_t columns, const Spacings& spacings) {
  Scene scene = empty_scene(2, count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t column = k % columns;
    const auto odd_steps = static_cast<double>((column + 1) / 2);
    const auto even_steps = static_cast<double>(column / 2);
    const auto row = static_cast<double>(k / columns);
    add_disc(scene, odd_steps * spacings.odd_x + even_steps * spacings.even_x, row * spacings.y,
             0.5);
  }
  return scene;
}

constexpr Spacings spacings_1() {
  return {1.0, 1.0, 2.0};
}
constexpr Spacings spacings_2(double spacing) {
  return {spacing, spacing, 2.0};
}
constexpr Spacings spacings_3(double spacing) {
  return {spacing, spacing, spacing};
}
constexpr Spacings spacings_4(double spacing) {
  return {1.0, spacing, 2.0};
}

}  // namespace

Scene pack_1(std::size_t rows, std::size_t columns) {
  return pack(rows * columns, columns, spacings_1());
}
Scene pack_2(std::size_t rows, std::size_t columns, double spacing) {
  return pack(rows * columns, columns, spacings_2(spacing));
}
Scene pack_3(std::size_t rows, std::size_t columns, double spacing) {
  return pack(rows * columns, columns, spacings_3(spacing));
}
Scene pack_4(std::size_t rows, std::size_t columns, double spacing) {
  return pack(rows * columns, columns, spacings_4(spacing));
}

Scene make_pack_1(std::size_t count, std::uint64_t) {
  return pack(count, side_of(count, 2), spacings_1());
}
Scene make_pack_2(std::size_t count, std::uint64_t) {
  return pack(count, side_of(count, 2), spacings_2(default_spacing));
}
Scene make_pack_3(std::size_t count, std::uint64_t) {
  return pack(count, side_of(count, 2), spacings_3(default_spacing));
}
Scene make_pack_4(std::size_t count, std::uint64_t) {
  return pack(count, side_of(count, 2), spacings_4(default_spacing));
}

}  // namespace abut::scenes
