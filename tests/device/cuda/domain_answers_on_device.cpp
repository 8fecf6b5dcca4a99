#include "device/domain_answers.hpp"
#include "device/face/face_detection.hpp"

#include <abut/options.hpp>

#include <rapidcheck.h>

#include <cstddef>
#include <optional>

namespace abut::testing {

DomainAnswers answers_in_domain(const ElementView& first, const ElementView* second,
                                const Domain& domain, double margin) {
  const device::ElementCopy copy(first);
  std::optional<device::ElementCopy> other;
  if (second != nullptr) other.emplace(*second);
  device::Detector detector({.margin = margin});
  const auto found = [&]() -> const device::PairList& {
    return other ? detector.find_contact_pairs(copy.elements(), other->elements(), domain)
                 : detector.find_contact_pairs(copy.elements(), domain);
  };
  DomainAnswers answers;
  const Statistics counted =
      other ? detector.count_contact_pairs(copy.elements(), other->elements(), domain)
            : detector.count_contact_pairs(copy.elements(), domain);
  answers.counted = counted.contact_pairs;
  answers.without_shifts = pairs_of(found().to_host());
  detector.set_options({.shifts = Shifts::stored, .margin = margin});
  const PairList shifted = found().to_host();
  RC_ASSERT(shifted.shifts().size() == shifted.size());
  for (std::size_t k = 0; k < shifted.size(); ++k) {
    answers.pairs.push_back({shifted.pairs()[k], shifted.shifts()[k]});
  }
  return answers;
}

}  // namespace abut::testing
