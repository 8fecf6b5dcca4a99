#include <abut/simplex_contacts.hpp>

#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "elements/lattice_of.hpp"
#include "elements/require_dimensions.hpp"
#include "exact/simplices/touch.hpp"
#include "simplices/gathered_simplices.hpp"
#include "simplices/simplex_search.hpp"

#include <abut/error.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace abut {
namespace {

PairList find(const simplices::SimplexRequest& request) {
  const base::FloatEnvironment environment;
  return request.first.dimensions() == 2 ? simplices::find<2>(request)
                                         : simplices::find<3>(request);
}

void require_in(const SimplexView& view, ElementIndex number) {
  if (number < view.size()) return;
  throw Error(ErrorCode::wrong_usage, "simplex " + std::to_string(number) + "; there are " +
                                          std::to_string(view.size()) + ", numbered from 0");
}

template <int Dim>
bool touching_in(const SimplexView& first, const SimplexView& second, const Domain& domain,
                 ContactPair pair, const ImageShift& shift) {
  std::uint64_t exact_decisions = 0;
  return exact::touch(simplices::simplex_at<Dim>(first, pair.first),
                      simplices::simplex_at<Dim>(second, pair.second), shift,
                      elements::lattice_of(domain), exact_decisions);
}

}  // namespace

PairList find_simplex_contacts(const SimplexView& simplices, const Options& options,
                               SharedVertices shared) {
  return find({simplices, Domain::open(), options, shared});
}

PairList find_simplex_contacts(const SimplexView& simplices, const Domain& domain,
                               const Options& options, SharedVertices shared) {
  return find({simplices, domain, options, shared});
}

PairList find_simplex_contacts(const SimplexView& first, const SimplexView& second,
                               const Options& options, SharedVertices shared) {
  return find({first, Domain::open(), options, shared, &second});
}

PairList find_simplex_contacts(const SimplexView& first, const SimplexView& second,
                               const Domain& domain, const Options& options,
                               SharedVertices shared) {
  return find({first, domain, options, shared, &second});
}

bool touching(const SimplexView& first, const SimplexView& second, ContactPair pair) {
  return touching(first, second, Domain::open(), pair, {});
}

bool touching(const SimplexView& first, const SimplexView& second, const Domain& domain,
              ContactPair pair, const ImageShift& shift) {
  const base::FloatEnvironment environment;
  return base::reporting_lack_of_memory([&] {
    require_in(first, pair.first);
    require_in(second, pair.second);
    simplices::require_same_dimensions(first, second);
    elements::require_dimensions(first.vertices(), domain);
    elements::require_there(domain, shift);
    return first.dimensions() == 2 ? touching_in<2>(first, second, domain, pair, shift)
                                   : touching_in<3>(first, second, domain, pair, shift);
  });
}

}  // namespace abut
