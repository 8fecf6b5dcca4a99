#include "elements/joined_sets.hpp"

#include "base/asking_workers.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <numeric>
#include <string>

namespace abut::elements {
namespace {

/// A set so many times larger than the other is looked at in cells; to cover these for more costs
/// more than it saves.
constexpr std::size_t times_larger = 16;

/// Gathers one set; the message about a bad element names the set.
template <int Dim>
void gather_set(const char* which, const ElementView& elements, const GatherSettings& settings,
                GatheredElements<Dim>& gathered, base::DetectionContext& context) {
  try {
    gather<Dim>(elements, settings, gathered, context);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_input) throw;
    throw Error(error.code(), std::string("in the ") + which + " set, " + error.what());
  }
}

}  // namespace

template <int Dim>
void JoinedSets<Dim>::keep_all(JoinedSet& set, std::size_t workers) {
  set.counts.resize(workers);
  for (std::size_t worker = 0; worker < workers; ++worker) {
    const auto [first, last] = base::share_of(worker, workers, set.size());
    set.counts[worker] = last - first;
  }
  set.count = set.size();
}

/// Keeps the elements that the mask does not rule out.
template <int Dim>
void JoinedSets<Dim>::keep_some(JoinedSet& set, std::size_t workers, base::WorkCounter& work) {
  base::make_room(set.kept, set.size());
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    const auto [first, last] = base::share_of(share, workers, set.size());
    const exact::Sphere<Dim>* const spheres = set.elements.spheres.data();
    std::size_t next = first;
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        set.kept[next] = static_cast<ElementIndex>(k);
        next += mask_.may_be_within_reach(spheres[k]) ? 1 : 0;
      }
    });
    set.counts[share] = next - first;
  });
  set.count = std::accumulate(set.counts.begin(), set.counts.end(), std::size_t{0});
}

template <int Dim>
void JoinedSets<Dim>::leave_out(const Search& search, base::WorkCounter& work) {
  const auto leave_out_far = [&](JoinedSet& set, const JoinedSet& other) {
    const auto& bounds = set.elements.bounds;
    mask_.cover_box(other.elements.bounds, bounds.largest_radius, search.margin);
    if (set.size() / times_larger >= other.size()) {
      mask_.cover_cells(other.elements.spheres);
      work.did(other.size());
    }
    if (!mask_.covers_all_of(bounds)) keep_some(set, search.gather.workers, work);
  };
  leave_out_far(first_, second_);
  leave_out_far(second_, first_);
}

template <int Dim>
void JoinedSets<Dim>::place(const JoinedSet& set, std::size_t worker, std::size_t begin,
                            GatheredElements<Dim>& joined, base::WorkCounter& work) {
  const std::size_t workers = set.counts.size();
  const std::size_t first = base::share_of(worker, workers, set.size()).first;
  const std::size_t count = set.counts[worker];
  std::size_t to = std::accumulate(set.counts.begin(),
                                   set.counts.begin() + static_cast<std::ptrdiff_t>(worker), begin);
  const bool all = set.count == set.size();
  const exact::Sphere<Dim>* const spheres = set.elements.spheres.data();
  const bool boxes = !set.elements.boxes.empty();
  grid::Bounds<Dim>& bounds = joined.parts[worker];
  const auto place_one = [&](std::size_t k) {
    const std::size_t number = all ? k : set.kept[k];
    joined.spheres[to] = spheres[number];
    if (boxes) joined.boxes[to] = set.elements.boxes[number];
    bounds.include_center(spheres[number]);
    bounds.include_radius(spheres[number].radius);
    if (!all_there_) numbers_[to] = static_cast<ElementIndex>(number);
    ++to;
  };
  work.in_pieces(first, first + count, [&](std::size_t from, std::size_t end) {
    for (std::size_t k = from; k < end; ++k) place_one(k);
  });
}

template <int Dim>
void JoinedSets<Dim>::join(std::size_t workers, GatheredElements<Dim>& joined,
                           base::WorkCounter& work) {
  all_there_ = first_.count == first_.size() && second_.count == second_.size();
  const std::size_t count = first_.count + second_.count;
  const bool boxes = !first_.elements.boxes.empty() || !second_.elements.boxes.empty();
  base::resize_for_overwrite(joined.spheres, count);
  base::resize_for_overwrite(joined.boxes, boxes ? count : 0);
  if (!all_there_) base::make_room(numbers_, count);
  joined.parts.assign(workers, {});
  base::for_each_share(workers, work, [&](std::size_t share, base::WorkCounter& its_work) {
    place(first_, share, 0, joined, its_work);
    place(second_, share, first_.count, joined, its_work);
  });
  joined.bounds = {};
  for (const grid::Bounds<Dim>& part : joined.parts) joined.bounds.include(part);
  if (boxes) joined.bounds.count_largest_twice();
  if (count == 0) joined.bounds = {.lower = {}, .upper = {}, .smallest_radius = 0.0};
}

template <int Dim>
void JoinedSets<Dim>::gather(const ElementView& first, const ElementView& second,
                             const Search& search, GatheredElements<Dim>& joined,
                             base::DetectionContext& context) {
  gather_set("first", first, search.gather, first_.elements, context);
  gather_set("second", second, search.gather, second_.elements, context);
  keep_all(first_, search.gather.workers);
  keep_all(second_, search.gather.workers);
  // The spheres that stand for boxes are rounded; the mask takes them at their word.
  const bool spheres = first.shape() == Shape::sphere;
  if (spheres && search.open_space && first.size() > 0 && second.size() > 0)
    leave_out(search, context.work);
  join(search.gather.workers, joined, context.work);
}

template class JoinedSets<2>;
template class JoinedSets<3>;

}  // namespace abut::elements
