#pragma once

#include "support/oracle.hpp"

#include <abut/device.hpp>
#include <abut/device_elements.hpp>
#include <abut/element_view.hpp>
#include <abut/options.hpp>
#include <abut/pair_list.hpp>

#include <cstddef>
#include <cstdlib>
#include <string>

/// Detections through the face of devices, by whatever backend the program is linked with: that of
/// CUDA, or the stand-in of host_backend.cpp.
namespace abut::testing {

/// Elements of a large scene: ABUT_SCENE_ELEMENTS, which scripts/test --device sets, or few.
[[nodiscard]] inline std::size_t elements_of_a_scene() {
  const char* const text = std::getenv("ABUT_SCENE_ELEMENTS");
  return text == nullptr ? 3000 : std::stoul(text);
}

[[nodiscard]] inline PairList list_by_face(const ElementView& on_host, const Options& options = {},
                                           const device::Allocator& allocator = {}) {
  const device::ElementCopy copy(on_host);
  device::Detector detector(options, device::on(0), allocator);
  return detector.find_contact_pairs(copy.elements()).to_host();
}

[[nodiscard]] inline Statistics count_by_face(const ElementView& on_host,
                                              const Options& options = {}) {
  const device::ElementCopy copy(on_host);
  return device::Detector(options).count_contact_pairs(copy.elements());
}

[[nodiscard]] inline PairVector pairs_of(const PairList& list) {
  return {list.begin(), list.end()};
}

}  // namespace abut::testing
