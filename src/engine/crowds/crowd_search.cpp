#include "engine/crowds/crowd_search.hpp"

#include "base/asking_workers.hpp"
#include "engine/crowds/crowded_part.hpp"
#include "engine/crowds/part_sink.hpp"
#include "engine/set_search.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace abut::engine {
namespace {

/// Elements that are worth all workers' time.
constexpr std::size_t large_crowd = 1 << 15;

/// Parts within parts that a worker searches at once, each with arrays of its own, before the next
/// one waits.
constexpr std::size_t parts_at_once = 4;

/// The largest crowd waits where it is at least one in so many elements of its set: arrays for
/// smaller ones are small.
constexpr std::size_t share_that_waits = 4;

/// Tests and decisions of a search.
struct PartWork {
  std::uint64_t tests = 0;
  std::uint64_t decisions = 0;

  void add(const base::DetectionContext& context) noexcept {
    tests += context.candidate_tests;
    decisions += context.exact_decisions;
  }
};

/// Searches a part by one worker while so many parts around are searched, and then what waits of
/// it, in the same arrays. Gives the part back where it came from.
template <int Dim>
PartWork search_by_one(std::unique_ptr<CrowdedPart<Dim>> part, WaitingParts<Dim>& origin_of_part,
                       const SearchInput<Dim>& whole, std::size_t around,
                       const base::Origin& origin, Workspace<Dim>& workspace) {
  PartSink sink(whole.sink, origin);
  const ProgressHook no_hook;  // the caller's is asked by way of the input
  PartWork work;
  const auto search = [&](std::unique_ptr<CrowdedPart<Dim>> one, WaitingParts<Dim>& its_origin) {
    SearchInput<Dim> input = one->input(whole, sink);
    input.part.unit = whole.part.unit_of(origin.unit);
    input.part.around = around;
    base::DetectionContext context(workspace.memory, no_hook);
    SetSearch<Dim>(input, workspace, 1, context, 0).search_part(one->set());
    work.add(context);
    its_origin.give_back(std::move(one));
  };
  WaitingParts<Dim>& waiting = workspace.waiting_parts();
  waiting.start();
  search(std::move(part), origin_of_part);
  for (auto parts = waiting.take(); !parts.empty(); parts = waiting.take()) {
    for (WaitingPart<Dim>& one : parts) search(std::move(one.part), waiting);
  }
  return work;
}

/// The arrays in which a worker searches a part while no other search goes on: the first one has
/// those of the whole set.
template <int Dim>
Workspace<Dim>& free_arrays(Workspace<Dim>& workspace, std::size_t worker) {
  return worker == 0 ? workspace : workspace.for_part(worker);
}

/// Notes that the elements of a part are searched. Parts of parts have been counted with these.
template <int Dim>
void advance(base::ProgressReporter& progress, const CrowdedPart<Dim>& part) {
  if (part.depth() == 1) progress.advance(part.crowd());
}

/// Searches small parts, each by one worker and as a unit. Returns the next unit.
template <int Dim>
std::uint64_t search_small_parts(std::span<WaitingPart<Dim>> parts, const SearchInput<Dim>& whole,
                                 Workspace<Dim>& workspace, std::size_t workers,
                                 base::DetectionContext& context, std::uint64_t unit) {
  std::vector<PartWork> work(workers);
  whole.sink.expect_units(unit, parts.size());
  base::WorkCounter own(whole.progress, 0);
  base::for_each_index(
      workers, parts.size(), own, [&](std::size_t w, std::size_t place, base::WorkCounter&) {
        const base::Origin origin{w, unit + place};
        whole.sink.begin_unit(origin);
        advance(context.progress, *parts[place].part);
        const PartWork its = search_by_one(std::move(parts[place].part), workspace.waiting_parts(),
                                           whole, 0, origin, free_arrays(workspace, w));
        work[w].tests += its.tests;
        work[w].decisions += its.decisions;
        whole.sink.finish_unit(origin);
      });
  for (const PartWork& its : work) {
    context.candidate_tests += its.tests;
    context.exact_decisions += its.decisions;
  }
  return unit + parts.size();
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
                         SearchWorker<Dim>& worker = *workspace_.workers[w];
                         worker.begin_unit(unit + place);
                         search_or_defer(grid, records, crowds.layers()[place], worker);
                         if (worker_count_ > 1) worker.finish_unit();
                       });
  return unit + count;
}

template <int Dim>
LayerElements<Dim> CrowdSearch<Dim>::rest(const LayerGrid<Dim>& grid,
                                          const LayerRecords<Dim>& records, std::size_t k,
                                          SearchWorker<Dim>& worker) {
  const std::size_t place = worker.origin().worker - workspace_.first_worker;
  return workspace_.layer_crowds.rest(grid, records, k, place, worker.work());
}

/// Tells whether the crowd of layer k waits. That must not depend on who searches.
template <int Dim>
bool CrowdSearch<Dim>::waits(std::size_t k, const CrowdedPart<Dim>& part) const {
  const LayerCrowds<Dim>& crowds = workspace_.layer_crowds;
  const std::size_t crowd = part.crowd();
  return crowd >= large_crowd || input_.part.around == parts_at_once ||
         (k == crowds.most_crowded() && share_that_waits * crowd >= crowds.elements());
}

template <int Dim>
void CrowdSearch<Dim>::search_or_defer(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records,
                                       std::size_t k, SearchWorker<Dim>& worker) {
  const LayerCrowds<Dim>& crowds = workspace_.layer_crowds;
  WaitingParts<Dim>& waiting = workspace_.waiting_parts();
  std::unique_ptr<CrowdedPart<Dim>> part = waiting.spare(crowds.in_layer(k).crowd);
  part->take(input_, grid, records, crowds, k, worker.work());
  if (part->may_have_pairs() && waits(k, *part)) {
    return waiting.add(input_.part.unit_of(worker.origin().unit), std::move(part));
  }
  context_.progress.advance(part->crowd());
  if (!part->may_have_pairs()) return waiting.give_back(std::move(part));
  worker.hand_over();
  const PartWork work = search_by_one(std::move(part), waiting, input_, input_.part.around + 1,
                                      worker.origin(), workspace_.for_part(worker.origin().worker));
  worker.count_in(work.tests, work.decisions);
}

template <int Dim>
std::uint64_t search_waiting_parts(const SearchInput<Dim>& whole, Workspace<Dim>& workspace,
                                   std::size_t workers, base::DetectionContext& context,
                                   std::uint64_t unit) {
  WaitingParts<Dim>& waiting = workspace.waiting_parts();
  const ProgressHook no_hook;  // the caller's is asked by way of the input
  const LastSearch of_whole = workspace.last;
  for (auto parts = waiting.take(); !parts.empty(); parts = waiting.take()) {
    std::vector<WaitingPart<Dim>> small;
    std::vector<WaitingPart<Dim>> large;
    for (WaitingPart<Dim>& one : parts) {
      (one.part->crowd() < large_crowd ? small : large).push_back(std::move(one));
    }
    for (const auto& worker : workspace.workers) workspace.keep_law(*worker);
    unit = search_small_parts<Dim>(small, whole, workspace, workers, context, unit);
    for (WaitingPart<Dim>& one : large) {
      const SearchInput<Dim> input = one.part->input(whole, whole.sink);
      base::DetectionContext inner(workspace.memory, no_hook);
      SetSearch<Dim> search(input, workspace, workers, inner, unit);
      search.search_part(one.part->set());
      unit = search.next_unit();
      context.candidate_tests += inner.candidate_tests;
      context.exact_decisions += inner.exact_decisions;
      advance(context.progress, *one.part);
      waiting.give_back(std::move(one.part));
    }
  }
  workspace.last = of_whole;
  return unit;
}

template class CrowdSearch<2>;
template class CrowdSearch<3>;
template std::uint64_t search_waiting_parts(const SearchInput<2>&, Workspace<2>&, std::size_t,
                                            base::DetectionContext&, std::uint64_t);
template std::uint64_t search_waiting_parts(const SearchInput<3>&, Workspace<3>&, std::size_t,
                                            base::DetectionContext&, std::uint64_t);

}  // namespace abut::engine
