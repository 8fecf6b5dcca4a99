#include "fuzz/byte_reader.hpp"
#include "fuzz/domain_maker.hpp"
#include "fuzz/element_maker.hpp"
#include "fuzz/number_maker.hpp"
#include "fuzz/wall_case.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace abut::fuzz {
namespace {

class WallDecoder {
 public:
  explicit WallDecoder(std::span<const std::uint8_t> bytes)
      : reader_(bytes),
        precision_(reader_.below(4) == 0 ? Precision::float32 : Precision::float64),
        numbers_(reader_, precision_) {}

  std::optional<WallCase> read() {
    for (std::uint8_t& choice : result_.choices) choice = reader_.byte();
    const int dimensions = reader_.below(3) == 0 ? 2 : 3;
    const DomainMaker domain(reader_, numbers_, dimensions, 1.0);
    const std::optional<Domain> made = domain.domain();
    if (!made) return std::nullopt;
    result_.domain = *made;
    result_.margin = reader_.below(3) == 0 ? numbers_.size() : 0.0;
    for (Storage& storage : result_.storage) {
      storage = {precision_, static_cast<Layout>(reader_.below(3)), false};
    }
    result_.balls = {dimensions, Shape::sphere, {}, {}, {}};
    result_.solids = {dimensions, Shape::box, {}, {}, {}};
    ElementMaker maker(reader_, numbers_, domain, result_.margin);
    add(maker, result_.solids, reader_.below(6));
    if (dimensions == 3) read_mesh();
    add(maker, result_.balls, 1 + reader_.below(5));
    place_on_vertices();
    return result_;
  }

 private:
  static void add(ElementMaker& maker, ElementArrays& elements, std::size_t count) {
    for (; count > 0; --count) maker.add(elements, -1.0, 1.0);
  }

  /// Vertices at the same place, triangles without area, twice the same one: all of this may be.
  void read_mesh() {
    for (std::size_t count = reader_.below(7); count > 0; --count) {
      result_.mesh.vertices.push_back({numbers_.number(), numbers_.number(), numbers_.number()});
    }
    const std::size_t vertices = result_.mesh.vertices.size();
    for (std::size_t count = vertices == 0 ? 0 : reader_.below(9); count > 0; --count) {
      testing::Cell cell{};
      for (int& vertex : cell) vertex = static_cast<int>(reader_.below(vertices));
      result_.mesh.triangles.push_back(cell);
    }
  }

  /// Some balls touch a vertex, or a midpoint of two, exactly or by a last place not.
  void place_on_vertices() {
    ElementArrays& balls = result_.balls;
    const auto& vertices = result_.mesh.vertices;
    for (std::size_t k = 0; k < balls.size() && !vertices.empty(); ++k) {
      if (reader_.below(3) != 0) continue;
      const testing::Point& p = vertices[reader_.below(vertices.size())];
      const testing::Point& q = vertices[reader_.below(vertices.size())];
      const std::size_t along = reader_.below(3);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double place = numbers_.fitted(0.5 * p[axis] + 0.5 * q[axis]);
        if (axis == along) {
          place = numbers_.nudged(numbers_.fitted(place + balls.radius[k] + result_.margin));
        }
        balls.lower[axis][k] = place;
      }
    }
  }

  ByteReader reader_;
  Precision precision_;
  NumberMaker numbers_;
  WallCase result_;
};

}  // namespace

std::optional<WallCase> decode_wall_case(std::span<const std::uint8_t> bytes) {
  return WallDecoder(bytes).read();
}

}  // namespace abut::fuzz
