#pragma once

#include "io/line_reader.hpp"
#include "io/snapshot.hpp"

#include <cstdint>
#include <functional>

namespace abut::io {

/// How one frame of a format is passed over and read. The reader stands at its first line.
struct FrameFormat {
  std::function<void(LineReader&)> skip;
  std::function<Snapshot(LineReader&)> read;
};

/// Reads one frame of a file of several, counted from 0 or, if negative, from the end, and counts
/// them all. Only the wanted frame is parsed; of a pipe only the text of as many frames is kept as
/// may still be wanted.
[[nodiscard]] Snapshot select_frame(LineReader& reader, std::int64_t wanted,
                                    const FrameFormat& format);

/// The number from 0 of the wanted frame. Throws Error{invalid_input} if there is none.
[[nodiscard]] std::int64_t frame_number(const LineReader& reader, std::int64_t wanted,
                                        std::int64_t frame_count);

}  // namespace abut::io
