#include "detect/two_set_search.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::detect {

template <int Dim>
void TwoSetSearch<Dim>::gather(const ElementView& first, const ElementView& second,
                               const SearchTask& task, elements::GatheredElements<Dim>& joined,
                               base::DetectionContext& context) {
  const elements::GatherSettings how{task.settings.workers, task.settings.simd};
  sets_.gather(first, second, {how, task.settings.margin, !task.domain.is_periodic()}, joined,
               context);
}

/// The search numbers the elements of both sets as one, and so do its messages.
template <int Dim>
void TwoSetSearch<Dim>::search(ElementSearch<Dim>& inner, elements::GatheredElements<Dim>& joined,
                               const SearchTask& task, base::PairSink& sink,
                               base::DetectionContext& context, Statistics& statistics) {
  const std::size_t first_count = sets_.first_count();
  crossing_.start_anew(sink, first_count, sets_.numbers());
  try {
    inner.search(joined, task, crossing_, context, statistics);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_input) throw;
    throw Error(error.code(), std::string(error.what()) +
                                  " (the elements of the second set are counted from " +
                                  std::to_string(first_count) + " on, behind those of the first)");
  }
}

template class TwoSetSearch<2>;
template class TwoSetSearch<3>;

}  // namespace abut::detect
