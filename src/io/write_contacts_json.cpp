#include "io/contact_writer.hpp"
#include "io/text_output.hpp"

#include <fmt/format.h>

namespace abut::io {

void write_contacts_json(ContactWriter& writer) {
  std::string& text = writer.text();
  const std::vector<std::int64_t>& ids = writer.snapshot().ids;
  text += fmt::format(
      "{{\n\"elements\": {},\n\"dimensions\": {},\n\"contact_pairs\": {},\n\"columns\": {},\n"
      "\"pairs\": [",
      writer.snapshot().size(), writer.snapshot().dimensions, writer.pairs().size(),
      writer.with_ids() ? R"(["i", "j", "id_i", "id_j", "gap"])" : R"(["i", "j", "gap"])");
  std::uint64_t written = 0;
  for (const ContactPair& pair : writer.pairs()) {
    text += written == 0 ? "\n[" : ",\n[";
    append_integer(pair.first, text);
    text += ", ";
    append_integer(pair.second, text);
    text += ", ";
    if (writer.with_ids()) {
      append_integer(ids[pair.first], text);
      text += ", ";
      append_integer(ids[pair.second], text);
      text += ", ";
    }
    append_shortest(writer.gap(pair), text);
    text += ']';
    writer.wrote(++written);
  }
  text += written == 0 ? "]\n}\n" : "\n]\n}\n";
  writer.finish();
}

}  // namespace abut::io
