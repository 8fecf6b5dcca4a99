#include "api/joined_sets.hpp"

#include "base/workers.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <string>

namespace abut::api {
namespace {

/// As gather, saying in which set a bad element is.
template <int Dim>
void gather_set(const char* which, const ElementView& elements, const GatherSettings& settings,
                GatheredElements<Dim>& gathered, base::DetectionContext& context) {
  try {
    api::gather<Dim>(elements, settings, gathered, context);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_input) throw;
    throw Error(error.code(), std::string("in the ") + which + " set, " + error.what());
  }
}

/// The worker's share of `from`, to its place behind the first `begin` of `to`.
template <class T>
void copy_share(const base::Array<T>& from, base::Array<T>& to, std::size_t begin,
                std::size_t worker, std::size_t workers) {
  const auto [first, last] = base::share_of(worker, workers, from.size());
  std::copy(from.data() + first, from.data() + last, to.data() + begin + first);
}

}  // namespace

template <int Dim>
void JoinedSets<Dim>::gather(const ElementView& first, const ElementView& second,
                             const GatherSettings& settings, GatheredElements<Dim>& joined,
                             base::DetectionContext& context) {
  gather_set("first", first, settings, first_, context);
  gather_set("second", second, settings, second_, context);
  auto& spheres = joined.spheres;
  const std::size_t count = first_.spheres.size() + second_.spheres.size();
  if (spheres.capacity() < count) spheres.clear();
  spheres.resize(count);
  base::for_each_worker(settings.workers, [&](std::size_t worker) {
    copy_share(first_.spheres, spheres, 0, worker, settings.workers);
    copy_share(second_.spheres, spheres, first_.spheres.size(), worker, settings.workers);
  });
  joined.bounds = first.size() == 0 ? second_.bounds : first_.bounds;
  if (first.size() != 0 && second.size() != 0) joined.bounds.include(second_.bounds);
}

template class JoinedSets<2>;
template class JoinedSets<3>;

}  // namespace abut::api
