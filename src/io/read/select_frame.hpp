#pragma once

#include "io/read/line_reader.hpp"
#include "io/read/read_snapshot.hpp"
#include "io/snapshot.hpp"

#include <cstdint>
#include <functional>

namespace abut::io {

/// The ways to pass over and to read one frame of a format. The reader stands at its first line.
struct FrameFormat {
  std::function<void(LineReader&)> skip;
  std::function<Snapshot(LineReader&)> read;
};

/// Reads the frame that the options want of a file of several, and counts them all. Only that frame
/// is parsed; of a pipe only the text of as many frames is kept as may still be wanted.
[[nodiscard]] Snapshot select_frame(LineReader& reader, const ReadOptions& options,
                                    const FrameFormat& format);

/// The number from 0 of the wanted frame. Throws Error{invalid_input} if there is none.
[[nodiscard]] std::int64_t frame_number(const LineReader& reader, const ReadOptions& options,
                                        std::int64_t frame_count);

}  // namespace abut::io
