#pragma once

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <span>
#include <string>

namespace abut::io {

/// "sha256:" and 64 hexadecimal digits: the SHA-256 of the pairs as given (canonical order), each
/// as little-endian uint32 first, uint32 second, and in periodic domains, where `shifts` runs
/// parallel, three int32 of its shift. No pairs: the SHA-256 of nothing.
[[nodiscard]] std::string digest(std::span<const ContactPair> pairs,
                                 std::span<const ImageShift> shifts = {});

}  // namespace abut::io
