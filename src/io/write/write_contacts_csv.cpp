#include "io/write/contact_writer.hpp"
#include "io/write/text_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <concepts>
#include <cstdint>
#include <string>

namespace abut::io {
namespace {

void append_field(std::integral auto value, std::string& text) {
  append_integer(value, text);
  text += ',';
}

}  // namespace

void write_contacts_csv(ContactWriter& writer) {
  std::string& text = writer.text();
  text += fmt::format("{}\n", fmt::join(writer.column_names(), ","));
  for (std::uint64_t k = 0; k < writer.pairs().size(); ++k) {
    const ContactPair& pair = writer.pairs()[k];
    append_field(pair.first, text);
    append_field(pair.second, text);
    if (writer.with_ids()) {
      append_field(writer.first_id(k), text);
      append_field(writer.second_id(k), text);
    }
    if (writer.is_periodic()) {
      const ImageShift shift = writer.shift(k);
      append_field(shift.x, text);
      append_field(shift.y, text);
      append_field(shift.z, text);
    }
    for (const QuantityColumns& quantity : writer.quantities()) {
      for (const double value : quantity.of(k)) {
        append_17_digits(value, text);
        text += ',';
      }
    }
    text.back() = '\n';
    writer.wrote(1);
  }
  writer.finish();
}

}  // namespace abut::io
