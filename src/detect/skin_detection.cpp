#include "detect/skin_detection.hpp"

#include <abut/column.hpp>
#include <abut/element_view.hpp>
#include <abut/error.hpp>
#include <abut/options.hpp>

#include <array>
#include <string>
#include <utility>

namespace abut::detect {
namespace {

/// Options of a search for candidates; without the caller's hook, which may be large to copy.
Options options_with_margin(const Options& options, double margin) {
  Options wider;
  wider.algorithm = options.algorithm;
  wider.margin = margin;
  wider.max_bytes = options.max_bytes;
  return wider;
}

engine::RowsSettings settings_with_margin(engine::RowsSettings settings, double margin) {
  settings.margin = margin;
  return settings;
}

template <int Dim>
ElementView view_of(std::span<const exact::Sphere<Dim>> spheres) {
  constexpr std::ptrdiff_t stride = sizeof(exact::Sphere<Dim>);
  std::array<Column<double>, Dim> centers{};
  Column<double> radii{nullptr, spheres.size(), stride};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    centers[axis] = {spheres.empty() ? nullptr : spheres[0].center + axis, spheres.size(), stride};
  }
  if (!spheres.empty()) radii.first = &spheres[0].radius;
  return ElementView(centers, radii);
}

skin::CallNow call_now(const SearchTask& task, base::DetectionContext& context) {
  const engine::RowsSettings& settings = task.settings;
  return {task.domain, settings.margin, settings.workers, settings.simd, context.work};
}

/// The elements where they lie now: a periodic search may have moved the array.
template <int Dim>
skin::ElementsNow<Dim> elements_now(const SkinCall<Dim>& call) {
  return {call_now(call.task, call.context), call.elements.spheres, call.elements.bounds};
}

}  // namespace

void SkinDetection::set_skin(Skin skin) {
  choice_.set(skin);
  statistics_ = {};
  arrays_.in_2d.candidates.release();
  arrays_.in_3d.candidates.release();
}

void SkinDetection::set_ids(std::span<const std::uint64_t> ids) {
  if (ids_.same(ids, ids.empty() ? ids_.size() : ids.size())) return;
  next_ids_.set(ids, ids.size());
  std::swap(ids_, next_ids_);
  ++ids_version_;
}

void SkinDetection::require_ids_for(std::size_t count) const {
  if (!ids_.given() || ids_.size() == count) return;
  throw Error(ErrorCode::invalid_input, std::to_string(ids_.size()) + " ids for " +
                                            std::to_string(count) +
                                            " elements; give one for each, or none");
}

bool SkinDetection::applies_to(const DetectionRequest& request) const noexcept {
  return request.others == nullptr && choice_.skin().kind() != Skin::Kind::none &&
         request.elements.shape() != Shape::box;
}

/// Names the elements; without ids another number of elements is as much of a change as other ids.
skin::NamedElements SkinDetection::name_elements(std::size_t count) {
  if (!ids_.given() && ids_.size() != count) {
    ids_.set({}, count);
    ++ids_version_;
  }
  return {ids_, ids_version_};
}

template <int Dim>
bool SkinDetection::find_candidates(const SkinCall<Dim>& call, const skin::NamedElements& named) {
  const auto search_wider = [&](double margin, base::PairSink& sink) {
    const Options options = options_with_margin(call.task.options, margin);
    const SearchTask wider{call.task.domain, options,
                           settings_with_margin(call.task.settings, margin)};
    call.search.search(call.elements, wider, sink, call.context, call.statistics);
  };
  const skin::SkinCounts counts{call.elements.spheres.size(), statistics_.candidates,
                                statistics_.survivors};
  const auto next_skin = [&](double reach) { return choice_.next_length(reach, Dim, counts); };
  return arrays_.in<Dim>().candidates.find_candidates(elements_now(call), named, next_skin,
                                                      search_wider);
}

template <int Dim>
void SkinDetection::search_insertion(const SkinCall<Dim>& call,
                                     const typename skin::SkinSearch<Dim>::Insertion& insertion) {
  elements::GatheredElements<Dim>& joined = arrays_.in<Dim>().insertion;
  const Options options = options_with_margin(call.task.options, insertion.margin);
  const SearchTask wider{insertion.domain, options,
                         settings_with_margin(call.task.settings, insertion.margin)};
  const ElementView added = view_of<Dim>(insertion.added);
  const ElementView all = view_of<Dim>(insertion.all);
  call.context.progress.begin("gather", added.size() + all.size());
  call.two_set_search.gather(added, all, wider, joined, call.context);
  Statistics statistics;
  call.two_set_search.search(call.search, joined, wider, insertion.sink, call.context, statistics);
}

template <int Dim>
bool SkinDetection::carry_over(const SkinCall<Dim>& call, const skin::NamedElements& named) {
  skin::SkinSearch<Dim>& candidates = arrays_.in<Dim>().candidates;
  const auto search_new = [&](const typename skin::SkinSearch<Dim>::Insertion& insertion) {
    search_insertion<Dim>(call, insertion);
  };
  if (!candidates.carry_over(elements_now(call), named, search_new)) return false;
  ++statistics_.carried;
  statistics_.inserted += candidates.added();
  return true;
}

template <int Dim>
SkinDetection::Source SkinDetection::find_source(const SkinCall<Dim>& call) {
  const skin::NamedElements named = name_elements(call.elements.spheres.size());
  if (arrays_.in<Dim>().candidates.covers(elements_now(call), named)) return Source::earlier_call;
  if (carry_over(call, named)) return Source::carried_over;
  return find_candidates(call, named) ? Source::this_call : Source::none;
}

void SkinDetection::note(Source source, const Statistics& statistics) {
  const bool kept = source == Source::earlier_call || source == Source::carried_over;
  ++(kept ? statistics_.reuses : statistics_.detections);
  if (source == Source::none) {
    statistics_.candidates = 0;
  } else {
    candidates_from_ = statistics.algorithm;
  }
}

/// Notes that candidates of an earlier call are tested.
void SkinDetection::note_kept(Source source, std::size_t elements, base::DetectionContext& context,
                              Statistics& statistics) {
  statistics.algorithm = candidates_from_;
  statistics.reason = "candidate pairs kept from an earlier call";
  context.progress.begin("search", elements);
  note(source, statistics);
}

template <int Dim>
SkinDetection::Source SkinDetection::prepare(const SkinCall<Dim>& call) {
  const Source source = find_source(call);
  if (source == Source::earlier_call || source == Source::carried_over) {
    note_kept(source, call.elements.spheres.size(), call.context, call.statistics);
  } else {
    note(source, call.statistics);
  }
  return source;
}

template <int Dim>
bool SkinDetection::prepare(const UngatheredCall& call) {
  const skin::NamedElements named = name_elements(call.elements.size());
  const skin::CallNow now = call_now(call.task, call.context);
  return arrays_.in<Dim>().candidates.covers(call.elements, now, named);
}

template <int Dim>
void SkinDetection::note_candidates(const SearchTask& task, Source source, Statistics& statistics) {
  const skin::SkinSearch<Dim>& candidates = arrays_.in<Dim>().candidates;
  statistics.threads = static_cast<int>(task.settings.workers);
  statistics_.candidates = candidates.candidates();
  statistics_.skin = candidates.skin();
  statistics_.approach = source == Source::this_call ? 0.0 : candidates.approach();
}

template <int Dim>
void SkinDetection::deliver(const SkinCall<Dim>& call, Source source, base::PairSink& sink) {
  skin::SkinSearch<Dim>& candidates = arrays_.in<Dim>().candidates;
  note_candidates<Dim>(call.task, source, call.statistics);
  candidates.deliver_contacts(elements_now(call), sink, call.context);
  source == Source::this_call ? choice_.detected(candidates.approach()) : choice_.reused();
}

template <int Dim>
void SkinDetection::deliver(const UngatheredCall& call, base::PairSink& sink) {
  note_kept(Source::earlier_call, call.elements.size(), call.context, call.statistics);
  note_candidates<Dim>(call.task, Source::earlier_call, call.statistics);
  arrays_.in<Dim>().candidates.deliver_contacts(call.elements, call_now(call.task, call.context),
                                                sink, call.context);
  choice_.reused();
}

template SkinDetection::Source SkinDetection::prepare<2>(const SkinCall<2>&);
template SkinDetection::Source SkinDetection::prepare<3>(const SkinCall<3>&);
template bool SkinDetection::prepare<2>(const UngatheredCall&);
template bool SkinDetection::prepare<3>(const UngatheredCall&);
template void SkinDetection::deliver<2>(const UngatheredCall&, base::PairSink&);
template void SkinDetection::deliver<3>(const UngatheredCall&, base::PairSink&);
template void SkinDetection::deliver<2>(const SkinCall<2>&, Source, base::PairSink&);
template void SkinDetection::deliver<3>(const SkinCall<3>&, Source, base::PairSink&);

}  // namespace abut::detect
