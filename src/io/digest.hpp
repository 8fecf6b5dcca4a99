#pragma once

#include <abut/pair.hpp>

#include <span>
#include <string>

namespace abut::io {

/// "sha256:" and 64 hexadecimal digits: the SHA-256 of the pairs as given (canonical order), each
/// as little-endian uint32 first, uint32 second. No pairs: the SHA-256 of nothing.
[[nodiscard]] std::string digest(std::span<const ContactPair> pairs);

}  // namespace abut::io
