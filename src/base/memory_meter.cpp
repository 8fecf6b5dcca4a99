#include "base/memory_meter.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::base {
namespace {

void raise_to(std::atomic<std::uint64_t>& peak, std::uint64_t value) noexcept {
  std::uint64_t seen = peak.load();
  while (seen < value && !peak.compare_exchange_weak(seen, value)) {
  }
}

}  // namespace

void MemoryMeter::start_anew(std::uint64_t bound) noexcept {
  bound_ = bound;
  peak_ = held_.load();
  working_peak_ = working_.load();
}

void MemoryMeter::require(std::uint64_t bytes, std::string_view what,
                          std::string_view advice) const {
  const std::uint64_t held = held_;
  if (bytes <= bound_ && held <= bound_ - bytes) return;
  std::string sentence = std::to_string(bytes) + " bytes are needed for " + std::string(what);
  if (held > 0) sentence += ", beside " + std::to_string(held) + " bytes already held";
  sentence += "; the memory bound is " + std::to_string(bound_) + " bytes: " + std::string(advice);
  throw Error(ErrorCode::limit_exceeded, sentence);
}

/// Two workers may pass the check at once and exceed the bound by one block, no more.
void MemoryMeter::hold(std::uint64_t bytes, std::string_view what, std::string_view advice) {
  require(bytes, what, advice);
  raise_to(peak_, held_ += bytes);
}

void MemoryMeter::take(std::uint64_t bytes) {
  hold(bytes, "a working array", "raise the memory bound or take fewer elements");
  raise_to(working_peak_, working_ += bytes);
}

void MemoryMeter::take_for_pairs(std::uint64_t bytes) {
  hold(bytes, "the list of contact pairs",
       "raise the memory bound or count the pairs without storing them");
}

}  // namespace abut::base
