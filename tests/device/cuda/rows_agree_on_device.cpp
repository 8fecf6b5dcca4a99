// What stands in for support/rows_variants.cpp in on_device_test: the systems that were made to
// break `rows` go through the face of devices.

#include "device/face/face_detection.hpp"
#include "support/rows_variants.hpp"
#include "support/same_pairs.hpp"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

std::vector<Simd> simd_levels_here() {
  return {Simd::scalar};
}

std::string told_simd_levels() {
  return "no SIMD levels: a device ran";
}

/// A list and a count.
AssertionResult rows_agree(std::span<const ContactPair> expected, const ElementView& elements,
                           double margin, std::initializer_list<int>) {
  const Options options{.margin = margin};
  const PairList list = list_by_face(elements, options);
  if (const auto same = same_canonical_pairs(expected, list.pairs()); !same) return same;
  const Statistics counted = count_by_face(elements, options);
  if (counted.contact_pairs != expected.size()) {
    return AssertionFailure() << counted.contact_pairs << " pairs counted instead of "
                              << expected.size();
  }
  return AssertionSuccess();
}

/// The same in a domain, with shifts.
AssertionResult rows_agree(const PairList& expected, const ElementView& elements,
                           const Domain& domain, double margin, std::initializer_list<int>) {
  const device::ElementCopy copy(elements);
  device::Detector detector({.shifts = Shifts::stored, .margin = margin});
  const PairList list = detector.find_contact_pairs(copy.elements(), domain).to_host();
  if (!std::ranges::equal(list.pairs(), expected.pairs()) ||
      !std::ranges::equal(list.shifts(), expected.shifts())) {
    return AssertionFailure() << list.size() << " pairs instead of the " << expected.size()
                              << " expected";
  }
  return AssertionSuccess();
}

}  // namespace abut::testing
