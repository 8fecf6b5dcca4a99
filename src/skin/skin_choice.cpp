#include "skin/skin_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::skin {
namespace {

/// Length of the skin before any motion was seen, in units of the reach.
constexpr double first_skin = 0.1;

/// A skin must last for some calls; elements that are too fast for one of the size of the reach are
/// better detected anew.
constexpr double fewest_calls = 2.0;

/// Shortest skin that is worth its candidates, in units of the reach: of elements at rest.
constexpr double shortest_skin = 1e-3;

/// Nanoseconds of one thread (benchmarks/systems/skin_costs.cpp): of a detection that keeps
/// candidates, and of a call that tests them. Only their ratios matter.
constexpr double detection_of_element = 50.0;
constexpr double detection_of_candidate = 20.0;
constexpr double reuse_of_element = 5.0;
constexpr double reuse_of_candidate = 1.6;
constexpr double reuse_of_survivor = 3.5;

/// Costs with a skin, from what was counted with another one.
class SkinCost {
 public:
  SkinCost(double reach, double length, int dimensions, const SkinCounts& counts) noexcept
      : reach_(reach), length_(length), counts_(counts), exponent_(dimensions) {
    // Candidates with no skin at all are the survivors. In between, and somewhat beyond, their
    // number is taken to be a power of the reach and the skin.
    if (counts.survivors == 0 || counts.candidates <= counts.survivors || !(length > 0.0)) return;
    const double growth =
        static_cast<double>(counts.candidates) / static_cast<double>(counts.survivors);
    exponent_ = std::min(std::log(growth) / std::log1p(length / reach), exponent_);
  }

  /// Cost of a call on average, where elements approach each other by so much in each.
  [[nodiscard]] double of_call(double length, double approach) const noexcept {
    const double elements = static_cast<double>(counts_.elements);
    const double candidates = static_cast<double>(counts_.candidates) *
                              std::pow((reach_ + length) / (reach_ + length_), exponent_);
    const double detection = detection_of_element * elements + detection_of_candidate * candidates;
    const double reuse = reuse_of_element * elements + reuse_of_candidate * candidates +
                         reuse_of_survivor * static_cast<double>(counts_.survivors);
    const double calls = length / approach;
    return (detection + calls * reuse) / (1.0 + calls);
  }

 private:
  double reach_;
  double length_;
  SkinCounts counts_;
  double exponent_;
};

}  // namespace

double SkinChoice::next_length(double reach, int dimensions, const SkinCounts& counts) noexcept {
  if (skin_.kind() == Skin::Kind::fixed) return length_ = skin_.length();
  // A reach beyond the largest double would make skins of all lengths infinite.
  if (!(reach > 0.0) || reach == std::numeric_limits<double>::infinity()) return length_ = 0.0;
  if (!approach_is_known_) return length_ = first_skin * reach;
  const double approach = std::max(approach_, std::numeric_limits<double>::min());
  const double shortest = std::max(fewest_calls * approach, shortest_skin * reach);
  if (shortest > reach) return length_ = 0.0;
  const SkinCost cost(reach, length_, dimensions, counts);
  constexpr double step = 1.05;
  double best = shortest;
  double least = cost.of_call(best, approach);
  for (double length = step * shortest; length <= reach; length *= step) {
    const double here = cost.of_call(length, approach);
    if (!(here < least)) continue;
    least = here;
    best = length;
  }
  return length_ = best;
}

void SkinChoice::detected(double approach) noexcept {
  if (approach < std::numeric_limits<double>::infinity()) {
    const double in_a_call = approach / static_cast<double>(reuses_ + 1);
    approach_ = approach_is_known_ ? 0.7 * approach_ + 0.3 * in_a_call : in_a_call;
    approach_is_known_ = true;
  }
  reuses_ = 0;
}

}  // namespace abut::skin
