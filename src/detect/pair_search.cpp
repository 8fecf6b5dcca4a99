#include "detect/pair_search.hpp"

#include "base/stopwatch.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "elements/validate_rule.hpp"
#include "kernels/simd_level.hpp"

namespace abut::detect {
namespace {

using base::DetectionContext;
using base::PairSink;
using base::Stopwatch;

SearchTask task_of(const DetectionRequest& request) {
  const Options& options = request.options;
  return {request.domain, options,
          engine::RowsSettings{options.margin, base::worker_count(options.threads, request.size()),
                               kernels::level_to_run(options.simd)}};
}

}  // namespace

void validate_request(const DetectionRequest& request) {
  if (request.others == nullptr) {
    validate(request.options, request.elements, request.domain);
  } else {
    validate(request.options, request.elements, *request.others, request.domain);
  }
  elements::validate_rule(request.options.rule, request.elements, request.others);
}

template <int Dim>
void PairSearch::search(const DetectionRequest& request, const SearchTask& task, PairSink& sink,
                        DetectionContext& context, Statistics& statistics) {
  SearchArrays<Dim>& own = arrays_.in<Dim>();
  if (request.others != nullptr) {
    return own.two_set_search.search(own.search, own.elements, task, sink, context, statistics);
  }
  if (skin_.applies_to(request)) {
    const SkinCall<Dim> call{own.elements, own.search, own.two_set_search,
                             task,         context,    statistics};
    const SkinDetection::Source source = skin_.prepare(call);
    if (source != SkinDetection::Source::none) return skin_.deliver(call, source, sink);
  }
  own.search.search(own.elements, task, sink, context, statistics);
}

/// Quantities are measured on gathered elements.
bool PairSearch::can_do_without_gathering(const DetectionRequest& request) const noexcept {
  return skin_.applies_to(request) && request.options.quantities.empty();
}

/// Quantities, and skins, need what was gathered.
bool PairSearch::may_search_in_place(const DetectionRequest& request) const noexcept {
  return request.others == nullptr && !skin_.applies_to(request) &&
         request.options.quantities.empty();
}

template <int Dim>
Statistics PairSearch::find_in(const DetectionRequest& request, PairSink& sink,
                               DetectionContext& context) {
  SearchArrays<Dim>& own = arrays_.in<Dim>();
  const SearchTask task = task_of(request);
  Statistics statistics;
  statistics.elements = request.size();
  statistics.dimensions = Dim;

  Stopwatch stopwatch;
  context.progress.begin("gather", request.size());
  const UngatheredCall ungathered{request.elements, task, context, statistics};
  if (can_do_without_gathering(request) && skin_.prepare<Dim>(ungathered)) {
    context.progress.advance(request.size());
    statistics.gather_seconds = stopwatch.lap();
    skin_.deliver<Dim>(ungathered, sink);
    statistics.search_seconds = stopwatch.lap();
    return statistics;
  }
  if (may_search_in_place(request)) {
    if (own.search.search_in_place(request.elements, task, own.elements, sink, context,
                                   statistics)) {
      statistics.search_seconds = stopwatch.lap() - statistics.gather_seconds;
      return statistics;
    }
    context.progress.begin("gather", request.size());
  }
  if (request.others == nullptr) {
    elements::gather<Dim>(request.elements, {task.settings.workers, task.settings.simd},
                          own.elements, context);
  } else {
    own.two_set_search.gather(request.elements, *request.others, task, own.elements, context);
  }
  statistics.gather_seconds = stopwatch.lap();
  search<Dim>(request, task, sink, context, statistics);
  statistics.search_seconds = stopwatch.lap();
  return statistics;
}

template <int Dim>
void PairSearch::give_back_memory_in(const DetectionRequest& request) {
  SearchArrays<Dim>& own = arrays_.in<Dim>();
  own.search.give_back_memory();
  if (!request.options.quantities.empty()) return;
  own.elements.give_back_memory();
  own.two_set_search.give_back_memory();
}

void PairSearch::give_back_memory(const DetectionRequest& request) {
  request.elements.dimensions() == 2 ? give_back_memory_in<2>(request)
                                     : give_back_memory_in<3>(request);
}

Statistics PairSearch::find(const DetectionRequest& request, PairSink& sink,
                            DetectionContext& context) {
  const PairRule& rule = request.options.rule;
  PairSink* target = &sink;
  if (!rule.is_empty()) {
    ruling_.start_anew(sink, rule, request.others == nullptr ? rule.elements : rule.others);
    target = &ruling_;
  }
  return request.elements.dimensions() == 2 ? find_in<2>(request, *target, context)
                                            : find_in<3>(request, *target, context);
}

}  // namespace abut::detect
