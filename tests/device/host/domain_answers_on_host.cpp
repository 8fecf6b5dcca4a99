#include "device/domain_answers.hpp"
#include "device/host/any_run.hpp"
#include "device/host/host_detection.hpp"

#include <cstddef>

namespace abut::testing {

DomainAnswers answers_in_domain(const ElementView& first, const ElementView* second,
                                const Domain& domain, double margin) {
  HostRun run = any_run();
  run.domain = domain;
  run.second = second;
  DomainAnswers answers;
  answers.counted = count_on_host(first, margin, run).count;
  answers.without_shifts = list_on_host(first, margin, run).pairs;
  run.shifts = Shifts::stored;
  const HostAnswer shifted = list_on_host(first, margin, run);
  RC_ASSERT(shifted.shifts.size() == shifted.pairs.size());
  for (std::size_t k = 0; k < shifted.pairs.size(); ++k) {
    answers.pairs.push_back({shifted.pairs[k], shifted.shifts[k]});
  }
  return answers;
}

}  // namespace abut::testing
