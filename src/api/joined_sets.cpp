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

/// Both arrays, one behind the other.
template <class T>
void join(const base::Array<T>& first, const base::Array<T>& second, base::Array<T>& joined,
          std::size_t workers) {
  base::resize_for_overwrite(joined, first.size() + second.size());
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto copy_share = [&](const base::Array<T>& from, T* to) {
      const auto [begin, end] = base::share_of(worker, workers, from.size());
      std::copy(from.data() + begin, from.data() + end, to + begin);
    };
    copy_share(first, joined.data());
    copy_share(second, joined.data() + first.size());
  });
}

}  // namespace

template <int Dim>
void JoinedSets<Dim>::gather(const ElementView& first, const ElementView& second,
                             const GatherSettings& settings, GatheredElements<Dim>& joined,
                             base::DetectionContext& context) {
  gather_set("first", first, settings, first_, context);
  gather_set("second", second, settings, second_, context);
  join(first_.spheres, second_.spheres, joined.spheres, settings.workers);
  join(first_.boxes, second_.boxes, joined.boxes, settings.workers);
  joined.bounds = first.size() == 0 ? second_.bounds : first_.bounds;
  if (first.size() != 0 && second.size() != 0) joined.bounds.include(second_.bounds);
  if (first.shape() == Shape::box) joined.bounds.count_largest_twice();
}

template class JoinedSets<2>;
template class JoinedSets<3>;

}  // namespace abut::api
