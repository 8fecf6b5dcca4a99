#include "io/read/select_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>

namespace abut::io {

std::int64_t frame_number(const LineReader& reader, const ReadOptions& options,
                          std::int64_t frame_count) {
  const std::int64_t wanted = options.frame.value_or(-1);
  if (frame_count == 1 && options.lone_frame == LoneFrame::always_taken) return 0;
  if (wanted >= -frame_count && wanted < frame_count) {
    return wanted < 0 ? wanted + frame_count : wanted;
  }
  if (frame_count == 1) {
    reader.fail(fmt::format("holds one frame, number 0; there is no frame {}", wanted));
  }
  reader.fail(fmt::format("holds {} frames, numbers 0 to {}; there is no frame {}", frame_count,
                          frame_count - 1, wanted));
}

Snapshot select_frame(LineReader& reader, const ReadOptions& options, const FrameFormat& format) {
  const std::int64_t wanted = options.frame.value_or(-1);
  const bool first_may_do = options.lone_frame == LoneFrame::always_taken;
  const std::uint64_t from_end = wanted < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(wanted)
                                 : first_may_do ? 1
                                                : 0;
  std::deque<TextPosition> last;  // where the last `from_end` frames start
  std::optional<Snapshot> found;
  std::int64_t frame_count = 0;
  for (; reader.skip_blank_lines(); ++frame_count) {
    if (frame_count == wanted) {
      found = format.read(reader);
      continue;
    }
    if (from_end > 0) {
      last.push_back(reader.position());
      if (last.size() > from_end) last.pop_front();
      reader.keep_from(last.front());
    }
    format.skip(reader);
  }
  if (frame_count == 0) reader.fail("is empty; there is no frame in it");
  const std::int64_t frame = frame_number(reader, options, frame_count);
  if (!found) {
    reader.seek(last.front());
    found = format.read(reader);
  }
  found->frame = frame;
  found->frame_count = frame_count;
  return *std::move(found);
}

}  // namespace abut::io
