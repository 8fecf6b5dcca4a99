#pragma once

#include "io/snapshot.hpp"

#include <cstdint>
#include <string>

namespace abut::cli {

/// The elements of a scene. Throws Error{wrong_usage} naming the scenes there are,
/// Error{limit_exceeded} before the memory of the machine would be exceeded.
[[nodiscard]] io::Snapshot make_scene(const std::string& name, std::uint64_t count,
                                      std::uint64_t seed);

}  // namespace abut::cli
