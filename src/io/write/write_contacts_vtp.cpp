#include "io/write/contact_points.hpp"
#include "io/write/contact_writer.hpp"
#include "io/write/little_endian.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
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
    numbers_ += values;
  }
  [[nodiscard]] std::uint64_t numbers() const { return numbers_; }
  void open(std::string_view tag) { text_ += fmt::format("      <{}>\n", tag); }
  void close(std::string_view tag) { text_ += fmt::format("      </{}>\n", tag); }

 private:
  std::string& text_;
  std::uint64_t offset_ = 0;
  std::uint64_t numbers_ = 0;  ///< of all arrays
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
  for (const QuantityColumns& quantity : writer.quantities()) {
    const std::size_t components = quantity.components();
    header.array("Float64", quantity.name, static_cast<int>(components), components * lines);
  }
  if (writer.is_periodic()) header.array("Int32", "shift", 3, 3 * lines);
  header.close("CellData");
  writer.expect(header.numbers());
  writer.text() += "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n   _";
}

/// Numbers as they lie in memory.
template <class Number>
void write_numbers(ContactWriter& writer, std::span<const Number> numbers) {
  if constexpr (std::endian::native == std::endian::little) {
    writer.write_bytes(std::as_bytes(numbers));
  } else {
    for (const Number number : numbers) append_little_endian(number, writer.text());
  }
  writer.wrote(numbers.size());
}

/// One appended array: its size in bytes, then `value(k)`, an array of numbers, for each k below
/// `count`.
template <class Value>
void write_tuples(ContactWriter& writer, std::uint64_t count, const Value& value) {
  using Numbers = decltype(value(std::uint64_t{0}));
  using Number = typename Numbers::value_type;
  constexpr std::uint64_t in_a_block = 4096;
  append_little_endian(count * sizeof(Numbers), writer.text());
  std::vector<Number> block;
  for (std::uint64_t k = 0; k < count;) {
    block.clear();
    for (const std::uint64_t end = std::min(count, k + in_a_block); k < end; ++k) {
      const Numbers numbers = value(k);
      block.insert(block.end(), numbers.begin(), numbers.end());
    }
    write_numbers(writer, std::span<const Number>(block));
  }
}

/// Writes an array of one number for each k.
template <class Value>
void write_array(ContactWriter& writer, std::uint64_t count, const Value& value) {
  write_tuples(writer, count, [&](std::uint64_t k) { return std::array{value(k)}; });
}

/// One appended array of numbers that lie in memory.
void write_column(ContactWriter& writer, std::span<const double> numbers) {
  constexpr std::size_t in_a_block = std::size_t{64} << 10;
  append_little_endian(std::uint64_t{numbers.size_bytes()}, writer.text());
  for (std::size_t k = 0; k < numbers.size(); k += in_a_block) {
    write_numbers(writer, numbers.subspan(k, std::min(in_a_block, numbers.size() - k)));
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
  write_tuples(writer, size, [&](std::uint64_t k) { return points.position(k); });
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
  write_tuples(writer, lines, [&](std::uint64_t k) {
    const bool to_image = writer.shift(k) != ImageShift{};
    const std::uint64_t end = to_image ? next_image++ : points.of_partner(pairs[k].second);
    return std::array{std::int64_t{pairs[k].first}, static_cast<std::int64_t>(end)};
  });
  write_array(writer, lines,
              [&](std::uint64_t k) { return static_cast<std::int64_t>(2 * (k + 1)); });
  for (const QuantityColumns& quantity : writer.quantities()) {
    write_column(writer, {quantity.first, quantity.components() * lines});
  }
  if (!writer.is_periodic()) return;
  write_tuples(writer, lines, [&](std::uint64_t k) {
    const ImageShift shift = writer.shift(k);
    return std::array{shift.x, shift.y, shift.z};
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
