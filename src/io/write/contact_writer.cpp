#include "io/write/contact_writer.hpp"

#include <abut/error.hpp>
#include <abut/measure.hpp>

#include <fmt/format.h>

namespace abut::io {

ContactWriter::ContactWriter(const ContactOutput& output, const ContactElements& elements,
                             std::span<const ContactPair> pairs, const ContactImages& images)
    : progress_(output.progress),
      now_{"write", 0, pairs.size()},
      file_(output.path, [this] { return is_cancelled(); }),
      elements_(elements),
      first_(elements.first.elements()),
      second_(elements.partners().elements()),
      pairs_(pairs),
      images_(images),
      gaps_(images.gaps),
      with_ids_(output.ids == IdColumns::with) {
  if (gaps_.size() == pairs.size()) return;
  own_gaps_ = measure(first_, second_, {pairs, images.shifts}, Quantity::gap, images.domain).gaps;
  gaps_ = own_gaps_;
}

std::vector<std::string_view> ContactWriter::column_names() const {
  std::vector<std::string_view> names{"i", "j"};
  if (with_ids_) names.insert(names.end(), {"id_i", "id_j"});
  if (is_periodic()) names.insert(names.end(), {"nx", "ny", "nz"});
  names.push_back("gap");
  return names;
}

void ContactWriter::hand_on() {
  constexpr std::size_t much = std::size_t{64} << 10;
  if (text_.size() < much) return;
  finish();
}

void ContactWriter::finish() {
  file_.write(text_);
  text_.clear();
}

void ContactWriter::wrote(std::uint64_t pairs) {
  constexpr std::uint64_t pairs_between_calls = 65536;
  hand_on();
  if (pairs % pairs_between_calls != 0) return;
  now_.done = pairs;
  if (!is_cancelled()) return;
  throw Error(ErrorCode::cancelled,
              fmt::format("cancelled after writing {} of {} contact pairs", pairs, pairs_.size()));
}

bool ContactWriter::is_cancelled() const {
  return progress_ && progress_(now_) == ProgressAction::cancel;
}

}  // namespace abut::io
