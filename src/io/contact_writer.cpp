#include "io/contact_writer.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <fmt/format.h>

namespace abut::io {

ContactWriter::ContactWriter(OutputFile& file, const ContactOutput& output,
                             const Snapshot& snapshot, std::span<const ContactPair> pairs)
    : file_(file),
      progress_(output.progress),
      snapshot_(snapshot),
      elements_(snapshot.elements()),
      pairs_(pairs),
      with_ids_(output.ids == IdColumns::with) {}

double ContactWriter::gap(const ContactPair& pair) const {
  return abut::gap(elements_, pair);
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
  if (!progress_ || pairs % pairs_between_calls != 0) return;
  if (progress_({"write", pairs, pairs_.size()}) == ProgressAction::proceed) return;
  throw Error(ErrorCode::cancelled,
              fmt::format("cancelled after writing {} of {} contact pairs", pairs, pairs_.size()));
}

}  // namespace abut::io
