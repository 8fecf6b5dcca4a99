#include "engine/crowds/crowd_search.hpp"

#include "base/asking_workers.hpp"
#include "engine/crowds/crowded_part.hpp"
#include "engine/crowds/part_sink.hpp"
#include "engine/set_search.hpp"

#include <memory>
#include <utility>

namespace abut::engine {
namespace {

/// Elements that are worth all workers' time.
constexpr std::size_t large_crowd = 1 << 15;

/// Parts of parts that a worker searches at once, each with arrays of its own, before the next one
/// waits.
constexpr std::size_t parts_at_once = 12;

bool goes_too_deep(const PartNumbers& part) {
  return part.depth % parts_at_once == parts_at_once - 1;
}

}  // namespace

template <int Dim>
std::uint64_t CrowdSearch<Dim>::search(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records,
                                       std::uint64_t unit) {
  LayerCrowds<Dim>& crowds = workspace_.layer_crowds;
  base::WorkCounter& work = workspace_.workers[0]->work();
  crowds.find(grid, records, input_.layer_limits, worker_count_, work);
  const std::size_t count = crowds.layers().size();
  input_.sink.expect_units(unit, count);
  base::for_each_index(worker_count_, count, work,
                       [&](std::size_t w, std::size_t place, base::WorkCounter&) {
                         TileSearcher<Dim>& worker = *workspace_.workers[w];
                         worker.begin_unit(unit + place);
                         search_or_defer(grid, records, crowds.layers()[place], worker);
                         if (worker_count_ > 1) worker.finish_unit();
                       });
  return unit + count;
}

template <int Dim>
LayerElements<Dim> CrowdSearch<Dim>::rest(const LayerGrid<Dim>& grid,
                                          const LayerRecords<Dim>& records, std::size_t k,
                                          TileSearcher<Dim>& worker) {
  const std::size_t place = worker.origin().worker - workspace_.first_worker;
  return workspace_.layer_crowds.rest(grid, records, k, place, worker.work());
}

template <int Dim>
void CrowdSearch<Dim>::search_or_defer(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records,
                                       std::size_t k, TileSearcher<Dim>& worker) {
  const LayerCrowds<Dim>& crowds = workspace_.layer_crowds;
  if (crowds.in_layer(k).crowd >= large_crowd || goes_too_deep(input_.part)) {
    std::unique_ptr<CrowdedPart<Dim>> part = waiting_.spare();
    part->take(input_, grid, records, crowds, k, worker.work());
    waiting_.add(input_.part.unit_of(worker.origin().unit), std::move(part));
    return;
  }
  PartScratch<Dim>& scratch = workspace_.part_scratch(worker.origin().worker);
  scratch.part->take(input_, grid, records, crowds, k, worker.work());
  search_at_once(*scratch.part, *scratch.workspace, worker);
  context_.progress.advance(scratch.part->crowd());
}

template <int Dim>
void CrowdSearch<Dim>::search_at_once(const CrowdedPart<Dim>& part, Workspace<Dim>& workspace,
                                      TileSearcher<Dim>& worker) {
  worker.hand_over();
  PartSink sink(input_.sink, worker.origin());
  SearchInput<Dim> input = part.input(input_, sink);
  input.part.unit = input_.part.unit_of(worker.origin().unit);
  const ProgressHook no_hook;  // the caller's is asked by way of the input
  base::DetectionContext context(workspace.memory, no_hook);
  SetSearch<Dim> search(input, workspace, 1, context, waiting_, 0);
  search.search_part(part.set());
  worker.count_in(context.candidate_tests, context.exact_decisions);
}

template <int Dim>
std::uint64_t search_waiting_parts(const SearchInput<Dim>& whole, Workspace<Dim>& workspace,
                                   std::size_t workers, base::DetectionContext& context,
                                   std::uint64_t unit) {
  WaitingParts<Dim>& waiting = workspace.waiting_parts();
  const ProgressHook no_hook;  // the caller's is asked by way of the input
  for (auto parts = waiting.take(); !parts.empty(); parts = waiting.take()) {
    for (WaitingPart<Dim>& one : parts) {
      const SearchInput<Dim> input = one.part->input(whole, whole.sink);
      base::DetectionContext inner(workspace.memory, no_hook);
      SetSearch<Dim> search(input, workspace.for_waiting(), workers, inner, waiting, unit);
      search.search_part(one.part->set());
      unit = search.next_unit();
      context.candidate_tests += inner.candidate_tests;
      context.exact_decisions += inner.exact_decisions;
      // Parts of parts have been counted with these.
      if (input.part.depth == 1) context.progress.advance(one.part->crowd());
      waiting.give_back(std::move(one.part));
    }
  }
  return unit;
}

template class CrowdSearch<2>;
template class CrowdSearch<3>;
template std::uint64_t search_waiting_parts(const SearchInput<2>&, Workspace<2>&, std::size_t,
                                            base::DetectionContext&, std::uint64_t);
template std::uint64_t search_waiting_parts(const SearchInput<3>&, Workspace<3>&, std::size_t,
                                            base::DetectionContext&, std::uint64_t);

}  // namespace abut::engine
