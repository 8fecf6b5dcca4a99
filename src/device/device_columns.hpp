#pragma once

#include <abut/element_view.hpp>
#include <abut/pair_rule.hpp>

#include <functional>

namespace abut::device {

/// Where an array lies, as a runtime knows.
struct ArrayPlace {
  enum class Memory { host, device, shared };

  Memory memory = Memory::host;
  int device = 0;  ///< whose memory it is
};
using FindPlace = std::function<ArrayPlace(const void* address)>;

/// Throws Error{wrong_usage} that names the first column which a device cannot read: one that is
/// null, not aligned for its numbers, or in the memory of the host or of another device.
void require_device_columns(const ElementView& spheres, int device, const FindPlace& place_of);

/// The same for the arrays of a rule.
void require_device_arrays(const PairRule& rule, int device, const FindPlace& place_of);

}  // namespace abut::device
