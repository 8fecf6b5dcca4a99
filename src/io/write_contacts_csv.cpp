#include "io/contact_writer.hpp"
#include "io/text_output.hpp"

namespace abut::io {

void write_contacts_csv(ContactWriter& writer) {
  std::string& text = writer.text();
  const std::vector<std::int64_t>& ids = writer.snapshot().ids;
  text += writer.with_ids() ? "i,j,id_i,id_j,gap\n" : "i,j,gap\n";
  std::uint64_t written = 0;
  for (const ContactPair& pair : writer.pairs()) {
    append_integer(pair.first, text);
    text += ',';
    append_integer(pair.second, text);
    text += ',';
    if (writer.with_ids()) {
      append_integer(ids[pair.first], text);
      text += ',';
      append_integer(ids[pair.second], text);
      text += ',';
    }
    append_17_digits(writer.gap(pair), text);
    text += '\n';
    writer.wrote(++written);
  }
  writer.finish();
}

}  // namespace abut::io
