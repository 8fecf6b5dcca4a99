#pragma once

#include "support/oracle.hpp"
#include "support/periodic_oracle.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/pair.hpp>

#include <vector>

namespace abut::testing {

/// What the device engine says of one system, asked in three ways.
struct DomainAnswers {
  PairCount counted = 0;
  PairVector without_shifts;
  std::vector<ImagePair> pairs;
};

/// Asks it for the contacts of elements with each other or, where `second` is not null, with those
/// of a second set: its stages on the host (domain_answers_on_host.cpp), or a device
/// (domain_answers_on_device.cpp). To be called within a property.
[[nodiscard]] DomainAnswers answers_in_domain(const ElementView& first, const ElementView* second,
                                              const Domain& domain, double margin);

}  // namespace abut::testing
