#include "io/write/contact_points.hpp"
#include "io/write/contact_writer.hpp"
#include "io/write/little_endian.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
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

void write_header(ContactWriter& writer, const ContactPoints& points) {
  const std::uint64_t lines = writer.pairs().size();
  const std::uint64_t size = points.size();
  writer.text() += fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "  <PolyData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
      size, lines);
  VtpHeader header(writer.text());
  header.open("Points");
  header.array("Float64", "Points", 3, 3 * size);
  header.close("Points");
  header.open(R"(PointData Scalars="radius")");
  header.array("Float64", "radius", 1, size);
  header.array("Int32", "coordination_number", 1, size);
  if (points.have_ids()) header.array("Int64", "id", 1, size);
  if (points.have_sets()) header.array("Int32", "set", 1, size);
  if (writer.is_periodic()) header.array("Int32", "image", 1, size);
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

std::vector<std::int32_t> coordination_numbers(const ContactWriter& writer,
                                               const ContactPoints& points) {
  std::vector<std::int32_t> numbers(writer.elements().size());
  for (const ContactPair& pair : writer.pairs()) {
    ++numbers[pair.first];
    ++numbers[points.of_partner(pair.second)];
  }
  return numbers;
}

void write_point_arrays(ContactWriter& writer, const ContactPoints& points) {
  const std::uint64_t size = points.size();
  write_array(writer, 3 * size, [&](std::uint64_t k) { return points.position(k / 3)[k % 3]; });
  write_array(writer, size, [&](std::uint64_t k) {
    const auto [snapshot, number] = points.element(k);
    return snapshot.radius[number];
  });
  const std::vector<std::int32_t> coordination = coordination_numbers(writer, points);
  write_array(writer, size, [&](std::uint64_t k) { return coordination[points.original(k)]; });
  if (points.have_ids()) {
    write_array(writer, size, [&](std::uint64_t k) {
      const auto [snapshot, number] = points.element(k);
      return snapshot.ids[number];
    });
  }
  if (points.have_sets()) {
    write_array(writer, size, [&](std::uint64_t k) { return points.set_of(k); });
  }
  if (writer.is_periodic()) {
    write_array(writer, size,
                [&](std::uint64_t k) { return std::int32_t{k >= points.first_image()}; });
  }
}

void write_line_arrays(ContactWriter& writer, const ContactPoints& points) {
  const std::span<const ContactPair> pairs = writer.pairs();
  const std::uint64_t lines = pairs.size();
  std::uint64_t next_image = points.first_image();
  write_array(writer, 2 * lines, [&](std::uint64_t k) {
    const ContactPair& pair = pairs[k / 2];
    if (k % 2 == 0) return static_cast<std::int64_t>(pair.first);
    const bool to_image = writer.shift(k / 2) != ImageShift{};
    return static_cast<std::int64_t>(to_image ? next_image++ : points.of_partner(pair.second));
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
  const ContactPoints points(writer);
  write_header(writer, points);
  write_point_arrays(writer, points);
  write_line_arrays(writer, points);
  writer.text() += "\n  </AppendedData>\n</VTKFile>\n";
  writer.finish();
}

}  // namespace abut::io
