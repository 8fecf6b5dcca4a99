#include "api/detection.hpp"
#include "api/skin_search.hpp"
#include "base/stopwatch.hpp"

#include <abut/options.hpp>

namespace abut::api {
namespace {

/// What a search looks at; not the caller's hook, which may be large.
Options options_with_margin(const Options& options, double margin) {
  Options wider;
  wider.algorithm = options.algorithm;
  wider.margin = margin;
  wider.max_bytes = options.max_bytes;
  return wider;
}

}  // namespace

void Detection::set_skin(Skin skin) {
  skin_choice_.set(skin);
  skin_statistics_ = {};
  in_2d_.skin_search.release();
  in_3d_.skin_search.release();
}

template <int Dim>
bool Detection::find_candidates(const Snapshot<Dim>& now, const engine::RowsSettings& settings,
                                const Request& request, base::DetectionContext& context,
                                Statistics& statistics) {
  const auto search_wider = [&](double margin, base::PairSink& sink) {
    engine::RowsSettings wider = settings;
    wider.margin = margin;
    const Options options = options_with_margin(request.options, margin);
    search<Dim>(wider, {request.elements, request.domain, options}, sink, context, statistics);
  };
  return arrays<Dim>().skin_search.find_candidates(now, skin_choice_, search_wider);
}

template <int Dim>
void Detection::search_with_skin(const engine::RowsSettings& settings, const Request& request,
                                 base::PairSink& sink, base::DetectionContext& context,
                                 Statistics& statistics) {
  Arrays<Dim>& own = arrays<Dim>();
  SkinSearch<Dim>& skin_search = own.skin_search;
  const Snapshot<Dim> now{own.elements.spheres, own.elements.bounds, request.domain,
                          settings.margin, settings.workers};
  base::Stopwatch stopwatch;
  const bool covered = skin_search.covers(now);
  if (covered) {
    statistics.algorithm = candidates_from_;
    statistics.reason = "candidate pairs kept from an earlier call";
    context.progress.begin("search", own.elements.spheres.size());
  } else if (!find_candidates<Dim>(now, settings, request, context, statistics)) {
    ++skin_statistics_.detections;
    skin_statistics_.candidates = 0;
    return search<Dim>(settings, request, sink, context, statistics);
  }
  candidates_from_ = statistics.algorithm;
  statistics.threads = static_cast<int>(settings.workers);
  ++(covered ? skin_statistics_.reuses : skin_statistics_.detections);
  skin_statistics_.candidates = skin_search.candidates();
  skin_statistics_.skin = skin_search.skin();
  skin_statistics_.approach = covered ? skin_search.approach() : 0.0;
  found_in_order_ = true;
  skin_search.deliver_contacts(now, sink, context);
  if (covered) {
    skin_choice_.reused(stopwatch.lap());
  } else {
    skin_choice_.detected(stopwatch.lap(), skin_search.approach());
  }
}

template void Detection::search_with_skin<2>(const engine::RowsSettings&, const Request&,
                                             base::PairSink&, base::DetectionContext&, Statistics&);
template void Detection::search_with_skin<3>(const engine::RowsSettings&, const Request&,
                                             base::PairSink&, base::DetectionContext&, Statistics&);

}  // namespace abut::api
