#include "base/lack_of_memory.hpp"
#include "device/copies/device_blocks.hpp"

#include <abut/device_elements.hpp>

#include <memory>

namespace abut::device {

struct RuleCopy::State {
  State(const PairRule& on_host, int device) : blocks(device), rule(on_host) {
    for (PairTraits* traits : {&rule.elements, &rule.others}) {
      traits->groups = blocks.copied(traits->groups);
      traits->categories = blocks.copied(traits->categories);
      traits->accepts = blocks.copied(traits->accepts);
    }
  }

  DeviceBlocks blocks;
  PairRule rule;
};

RuleCopy::RuleCopy(const PairRule& on_host, Device device)
    : state_(base::reporting_lack_of_memory(
          [&] { return std::make_unique<State>(on_host, device.number); })) {}

RuleCopy::~RuleCopy() = default;
RuleCopy::RuleCopy(RuleCopy&&) noexcept = default;
RuleCopy& RuleCopy::operator=(RuleCopy&&) noexcept = default;

const PairRule& RuleCopy::rule() const noexcept {
  return state_->rule;
}

}  // namespace abut::device
