#include "base/memory_meter.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut::base {

void MemoryMeter::require(std::uint64_t bytes, std::string_view what,
                          std::string_view advice) const {
  if (bytes <= bound_ && held_ <= bound_ - bytes) return;
  std::string sentence = std::to_string(bytes) + " bytes are needed for " + std::string(what);
  if (held_ > 0) sentence += ", beside " + std::to_string(held_) + " bytes already held";
  sentence += "; the memory bound is " + std::to_string(bound_) + " bytes: " + std::string(advice);
  throw Error(ErrorCode::limit_exceeded, sentence);
}

void MemoryMeter::take(std::uint64_t bytes) {
  require(bytes, "a working array", "raise the memory bound or take fewer elements");
  held_ += bytes;
  peak_ = std::max(peak_, held_);
  working_peak_ = std::max(working_peak_, held_ - pairs_held_);
}

void MemoryMeter::take_for_pairs(std::uint64_t bytes) {
  require(bytes, "the list of contact pairs",
          "raise the memory bound or count the pairs without storing them");
  held_ += bytes;
  pairs_held_ += bytes;
  peak_ = std::max(peak_, held_);
}

void MemoryMeter::give_back_pairs(std::uint64_t bytes) noexcept {
  held_ -= bytes;
  pairs_held_ -= bytes;
}

}  // namespace abut::base
