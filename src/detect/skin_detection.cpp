#include "base/stopwatch.hpp"
#include "detect/detection.hpp"
#include "skin/skin_search.hpp"

#include <abut/column.hpp>
#include <abut/element_view.hpp>
#include <abut/error.hpp>
#include <abut/options.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>

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

template <int Dim>
ElementView view_of(std::span<const base::Sphere<Dim>> spheres) {
  constexpr std::ptrdiff_t stride = sizeof(base::Sphere<Dim>);
  std::array<Column<double>, Dim> centers{};
  Column<double> radii{nullptr, spheres.size(), stride};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    centers[axis] = {spheres.empty() ? nullptr : spheres[0].center + axis, spheres.size(), stride};
  }
  if (!spheres.empty()) radii.first = &spheres[0].radius;
  return ElementView(centers, radii);
}

/// While it lives, what is at one place is at another.
template <class T>
class Exchange {
 public:
  Exchange(T& a, T& b) : a_(a), b_(b) { std::swap(a_, b_); }
  ~Exchange() { std::swap(a_, b_); }

  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

 private:
  T& a_;
  T& b_;
};

}  // namespace

void Detection::set_skin(Skin skin) {
  skin_choice_.set(skin);
  skin_statistics_ = {};
  in_2d_.skin_search.release();
  in_3d_.skin_search.release();
}

void Detection::set_ids(std::span<const std::uint64_t> ids) {
  if (ids_.same(ids, ids.empty() ? ids_.size() : ids.size())) return;
  next_ids_.set(ids, ids.size());
  std::swap(ids_, next_ids_);
  ++ids_version_;
}

void Detection::require_ids_for(const Request& request) const {
  const std::size_t count = request.elements.size();
  if (!ids_.given() || ids_.size() == count) return;
  throw Error(ErrorCode::invalid_input, std::to_string(ids_.size()) + " ids for " +
                                            std::to_string(count) +
                                            " elements; give one for each, or none");
}

/// Without ids another number of elements is as much of a change as other ids.
NamedElements Detection::name_elements(std::size_t count) {
  if (!ids_.given() && ids_.size() != count) {
    ids_.set({}, count);
    ++ids_version_;
  }
  return {ids_, ids_version_};
}

/// Of the arrays as they are: a search may have moved them in memory.
template <int Dim>
Snapshot<Dim> Detection::snapshot(const engine::RowsSettings& settings, const Request& request) {
  const GatheredElements<Dim>& elements = arrays<Dim>().elements;
  return {elements.spheres, elements.bounds,  request.domain,
          settings.margin,  settings.workers, settings.simd};
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
  const NamedElements named = name_elements(now.spheres.size());
  return arrays<Dim>().skin_search.find_candidates(now, named, skin_choice_, search_wider);
}

template <int Dim>
void Detection::search_insertion(const engine::RowsSettings& settings, const Request& request,
                                 const typename SkinSearch<Dim>::Insertion& insertion,
                                 base::DetectionContext& context) {
  Arrays<Dim>& own = arrays<Dim>();
  const Exchange aside(own.elements, own.elements_aside);
  engine::RowsSettings wider = settings;
  wider.margin = insertion.margin;
  const Options options = options_with_margin(request.options, insertion.margin);
  const ElementView added = view_of<Dim>(insertion.added);
  const ElementView all = view_of<Dim>(insertion.all);
  const Request sets{added, insertion.domain, options, &all};
  gather<Dim>(wider, sets, context);
  Statistics statistics;
  search_sets<Dim>(wider, sets, insertion.sink, context, statistics);
}

template <int Dim>
bool Detection::has_candidates(const engine::RowsSettings& settings, const Request& request,
                               base::DetectionContext& context) {
  SkinSearch<Dim>& skin_search = arrays<Dim>().skin_search;
  const Snapshot<Dim> now = snapshot<Dim>(settings, request);
  const NamedElements named = name_elements(now.spheres.size());
  if (skin_search.covers(now, named)) return true;
  const auto search_new = [&](const typename SkinSearch<Dim>::Insertion& insertion) {
    search_insertion<Dim>(settings, request, insertion, context);
  };
  if (!skin_search.carry_over(now, named, search_new)) return false;
  ++skin_statistics_.carried;
  skin_statistics_.inserted += skin_search.added();
  return true;
}

template <int Dim>
void Detection::search_with_skin(const engine::RowsSettings& settings, const Request& request,
                                 base::PairSink& sink, base::DetectionContext& context,
                                 Statistics& statistics) {
  SkinSearch<Dim>& skin_search = arrays<Dim>().skin_search;
  base::Stopwatch stopwatch;
  const std::uint64_t carried = skin_statistics_.carried;
  const bool covered = has_candidates<Dim>(settings, request, context);
  if (covered) {
    statistics.algorithm = candidates_from_;
    statistics.reason = "candidate pairs kept from an earlier call";
    context.progress.begin("search", request.elements.size());
  } else if (!find_candidates<Dim>(snapshot<Dim>(settings, request), settings, request, context,
                                   statistics)) {
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
  if (!request.list_room.pairs.empty()) found_.lend(request.list_room);
  skin_search.deliver_contacts(snapshot<Dim>(settings, request), sink, context);
  if (!covered) {
    skin_choice_.detected(stopwatch.lap(), skin_search.approach());
  } else if (skin_statistics_.carried > carried) {
    skin_choice_.carried();
  } else {
    skin_choice_.reused(stopwatch.lap());
  }
}

template void Detection::search_with_skin<2>(const engine::RowsSettings&, const Request&,
                                             base::PairSink&, base::DetectionContext&, Statistics&);
template void Detection::search_with_skin<3>(const engine::RowsSettings&, const Request&,
                                             base::PairSink&, base::DetectionContext&, Statistics&);

}  // namespace abut::api
