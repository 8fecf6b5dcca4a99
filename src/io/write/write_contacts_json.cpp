#include "io/write/contact_writer.hpp"
#include "io/write/text_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <concepts>
#include <cstdint>
#include <string>

namespace abut::io {
namespace {

void append_entry(std::integral auto value, std::string& text) {
  append_integer(value, text);
  text += ", ";
}

}  // namespace

void write_contacts_json(ContactWriter& writer) {
  std::string& text = writer.text();
  const ContactElements& elements = writer.elements();
  text += fmt::format("{{\n\"elements\": {},\n", elements.size());
  if (elements.are_of_two_sets()) {
    text += fmt::format("\"sets\": [{}, {}],\n", elements.first.size(), elements.second->size());
  }
  text += fmt::format(
      "\"dimensions\": {},\n\"contact_pairs\": {},\n\"columns\": [\"{}\"],\n\"pairs\": [",
      elements.first.dimensions, writer.pairs().size(), fmt::join(writer.column_names(), "\", \""));
  for (std::uint64_t k = 0; k < writer.pairs().size(); ++k) {
    const ContactPair& pair = writer.pairs()[k];
    text += k == 0 ? "\n[" : ",\n[";
    append_entry(pair.first, text);
    append_entry(pair.second, text);
    if (writer.with_ids()) {
      append_entry(writer.first_id(k), text);
      append_entry(writer.second_id(k), text);
    }
    if (writer.is_periodic()) {
      const ImageShift shift = writer.shift(k);
      append_entry(shift.x, text);
      append_entry(shift.y, text);
      append_entry(shift.z, text);
    }
    for (const QuantityColumns& quantity : writer.quantities()) {
      for (const double value : quantity.of(k)) {
        append_shortest(value, text);
        text += ", ";
      }
    }
    text.resize(text.size() - 2);
    text += ']';
    writer.wrote(1);
  }
  text += writer.pairs().empty() ? "]\n}\n" : "\n]\n}\n";
  writer.finish();
}

}  // namespace abut::io
