#include "benchmarks/packs/verify.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

using Pairs = std::vector<ContactPair>;

Pairs list(const ElementView& elements, Algorithm algorithm, Order order) {
  Options options;
  options.algorithm = algorithm;
  options.order = order;
  const PairList found = find_contact_pairs(elements, Domain::open(), options);
  return {found.begin(), found.end()};
}

void require(bool condition, const PackCase& pack, const AlgorithmInfo& contestant,
             const std::string& what) {
  if (condition) return;
  throw Error(ErrorCode::check_failed, name_of(pack) + ": " + std::string(contestant.name) + " " +
                                           what + "; nothing is timed");
}

void verify(const PackCase& pack, const ElementView& elements, const AlgorithmInfo& contestant,
            std::optional<Pairs>& reference) {
  Pairs canonical = list(elements, contestant.algorithm, Order::canonical);
  require(canonical.size() == expected_contact_pairs(pack), pack, contestant,
          "finds " + std::to_string(canonical.size()) + " contact pairs instead of " +
              std::to_string(expected_contact_pairs(pack)));
  Pairs as_found = list(elements, contestant.algorithm, Order::as_found);
  std::sort(as_found.begin(), as_found.end());
  require(as_found == canonical, pack, contestant, "gives other pairs in the order as found");
  Options options;
  options.algorithm = contestant.algorithm;
  const Statistics counted = count_contact_pairs(elements, Domain::open(), options);
  require(counted.contact_pairs == canonical.size(), pack, contestant, "counts other pairs");
  if (!reference)
    reference = std::move(canonical);
  else
    require(canonical == *reference, pack, contestant, "gives other pairs than those before it");
}

}  // namespace

bool takes_part(const AlgorithmInfo& contestant, std::size_t elements) {
  if (contestant.min_dimensions > 2) return false;
  return contestant.algorithm != Algorithm::direct_check ||
         elements <= most_elements_for_direct_check;
}

void verify(const PackCase& pack, const ElementView& elements) {
  std::optional<Pairs> reference;  // direct_check is the first row of the registry
  for (const AlgorithmInfo& contestant : algorithms()) {
    if (!takes_part(contestant, elements.size())) continue;
    try {
      verify(pack, elements, contestant, reference);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::limit_exceeded) throw;
    }
  }
}

}  // namespace abut::benchmarks
