#include "io/contact_writer.hpp"
#include "io/little_endian.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <vector>

/// VTK PolyData in XML, version 1.0 with header type UInt64: the arrays lie raw behind "_" in the
/// order of the header, each behind its size in bytes, little-endian on every machine ("VTK XML
/// Formats", docs.vtk.org).
namespace abut::io {
namespace {

/// Writes the entries of the XML header, keeping account of where each array will lie.
class VtpHeader {
 public:
  explicit VtpHeader(std::string& text) : text_(text) {}

  void array(std::string_view type, std::string_view name, int components, std::uint64_t values) {
    constexpr std::uint64_t size_bytes = 8;  // the size in front of the array
    const std::uint64_t value_bytes = type == "Int32" ? 4 : 8;
    text_ += fmt::format(
        R"(        <DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" )"
        "offset=\"{}\"/>\n",
        type, name, components, offset_);
    offset_ += size_bytes + value_bytes * values;
  }
  void open(std::string_view tag) { text_ += fmt::format("      <{}>\n", tag); }
  void close(std::string_view tag) { text_ += fmt::format("      </{}>\n", tag); }

 private:
  std::string& text_;
  std::uint64_t offset_ = 0;
};

/// Pairs whose line ends in an image of an element: a point of its own behind the elements.
std::vector<std::uint64_t> pairs_with_image(const ContactWriter& writer) {
  std::vector<std::uint64_t> numbers;
  if (!writer.is_periodic()) return numbers;
  for (std::uint64_t k = 0; k < writer.pairs().size(); ++k) {
    if (writer.shift(k) != ImageShift{}) numbers.push_back(k);
  }
  return numbers;
}

void write_header(ContactWriter& writer, std::uint64_t points) {
  const std::uint64_t lines = writer.pairs().size();
  writer.text() += fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "  <PolyData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
      points, lines);
  VtpHeader header(writer.text());
  header.open("Points");
  header.array("Float64", "Points", 3, 3 * points);
  header.close("Points");
  header.open(R"(PointData Scalars="radius")");
  header.array("Float64", "radius", 1, points);
  header.array("Int32", "coordination_number", 1, points);
  if (!writer.snapshot().ids.empty()) header.array("Int64", "id", 1, points);
  if (writer.is_periodic()) header.array("Int32", "image", 1, points);
  header.close("PointData");
  header.open("Lines");
  header.array("Int64", "connectivity", 1, 2 * lines);
  header.array("Int64", "offsets", 1, lines);
  header.close("Lines");
  header.open(R"(CellData Scalars="gap")");
  header.array("Float64", "gap", 1, lines);
  if (writer.is_periodic()) header.array("Int32", "shift", 3, 3 * lines);
  header.close("CellData");
  writer.text() += "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n   _";
}

/// One appended array: its size in bytes, then `value(k)` for each k below `count`.
template <class Value>
void write_array(ContactWriter& writer, std::uint64_t count, const Value& value) {
  append_little_endian(count * sizeof(value(0)), writer.text());
  for (std::uint64_t k = 0; k < count; ++k) {
    append_little_endian(value(k), writer.text());
    writer.hand_on();
  }
}

std::vector<std::int32_t> coordination_numbers(const ContactWriter& writer) {
  std::vector<std::int32_t> numbers(writer.snapshot().size());
  for (const ContactPair& pair : writer.pairs()) {
    ++numbers[pair.first];
    ++numbers[pair.second];
  }
  return numbers;
}

/// The image of a pair's second element; rounded, for pictures.
std::array<double, 3> image_position(const ContactWriter& writer, std::uint64_t pair) {
  const Snapshot& snapshot = writer.snapshot();
  const ElementIndex element = writer.pairs()[pair].second;
  std::array<double, 3> position{snapshot.x[element], snapshot.y[element],
                                 snapshot.dimensions == 2 ? 0.0 : snapshot.z[element]};
  const ImageShift shift = writer.shift(pair);
  const std::array<std::int32_t, 3> numbers{shift.x, shift.y, shift.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 3; ++k) {
      const Domain::Vector& vector = writer.domain().vector(k);
      position[axis] += numbers[static_cast<std::size_t>(k)] * vector[axis];
    }
  }
  return position;
}

void write_point_arrays(ContactWriter& writer, const std::vector<std::uint64_t>& images) {
  const Snapshot& snapshot = writer.snapshot();
  const std::uint64_t elements = snapshot.size();
  const std::uint64_t points = elements + images.size();
  const bool flat = snapshot.dimensions == 2;
  const auto element_of = [&](std::uint64_t point) -> std::uint64_t {
    return point < elements ? point : writer.pairs()[images[point - elements]].second;
  };
  write_array(writer, 3 * points, [&](std::uint64_t k) {
    const std::uint64_t point = k / 3;
    if (point >= elements) return image_position(writer, images[point - elements])[k % 3];
    if (k % 3 == 2) return flat ? 0.0 : snapshot.z[point];
    return k % 3 == 0 ? snapshot.x[point] : snapshot.y[point];
  });
  write_array(writer, points, [&](std::uint64_t k) { return snapshot.radius[element_of(k)]; });
  const std::vector<std::int32_t> coordination = coordination_numbers(writer);
  write_array(writer, points, [&](std::uint64_t k) { return coordination[element_of(k)]; });
  if (!snapshot.ids.empty()) {
    write_array(writer, points, [&](std::uint64_t k) { return snapshot.ids[element_of(k)]; });
  }
  if (writer.is_periodic()) {
    write_array(writer, points, [&](std::uint64_t k) { return std::int32_t{k >= elements}; });
  }
}

void write_line_arrays(ContactWriter& writer) {
  const std::span<const ContactPair> pairs = writer.pairs();
  const std::uint64_t lines = pairs.size();
  std::uint64_t next_image = writer.snapshot().size();
  write_array(writer, 2 * lines, [&](std::uint64_t k) {
    const ContactPair& pair = pairs[k / 2];
    if (k % 2 == 0) return static_cast<std::int64_t>(pair.first);
    const bool to_image = writer.shift(k / 2) != ImageShift{};
    return static_cast<std::int64_t>(to_image ? next_image++ : pair.second);
  });
  write_array(writer, lines,
              [&](std::uint64_t k) { return static_cast<std::int64_t>(2 * (k + 1)); });
  write_array(writer, lines, [&](std::uint64_t k) {
    writer.wrote(k + 1);
    return writer.gap(k);
  });
  if (!writer.is_periodic()) return;
  write_array(writer, 3 * lines, [&](std::uint64_t k) {
    const ImageShift shift = writer.shift(k / 3);
    return k % 3 == 0 ? shift.x : k % 3 == 1 ? shift.y : shift.z;
  });
}

}  // namespace

void write_contacts_vtp(ContactWriter& writer) {
  const std::vector<std::uint64_t> images = pairs_with_image(writer);
  write_header(writer, writer.snapshot().size() + images.size());
  write_point_arrays(writer, images);
  write_line_arrays(writer);
  writer.text() += "\n  </AppendedData>\n</VTKFile>\n";
  writer.finish();
}

}  // namespace abut::io
