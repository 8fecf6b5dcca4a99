#include "elements/joined_sets.hpp"

#include "base/workers.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <numeric>
#include <string>

namespace abut::api {
namespace {

/// A set so many times larger than the other is looked at in cells; to cover these for more costs
/// more than it saves.
constexpr std::size_t times_larger = 16;

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

}  // namespace

template <int Dim>
void JoinedSets<Dim>::keep_all(Set& set, std::size_t workers) {
  set.counts.resize(workers);
  for (std::size_t worker = 0; worker < workers; ++worker) {
    const auto [first, last] = base::share_of(worker, workers, set.size());
    set.counts[worker] = last - first;
  }
  set.count = set.size();
}

/// Those that the mask does not rule out.
template <int Dim>
void JoinedSets<Dim>::keep_some(Set& set, std::size_t workers) {
  base::make_room(set.kept, set.size());
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, set.size());
    const base::Sphere<Dim>* const spheres = set.elements.spheres.data();
    std::size_t end = first;
    for (std::size_t k = first; k < last; ++k) {
      set.kept[end] = static_cast<ElementIndex>(k);
      end += mask_.may_be_within_reach(spheres[k]) ? 1 : 0;
    }
    set.counts[worker] = end - first;
  });
  set.count = std::accumulate(set.counts.begin(), set.counts.end(), std::size_t{0});
}

template <int Dim>
void JoinedSets<Dim>::leave_out(const Search& search) {
  const auto leave_out_far = [&](Set& set, const Set& other) {
    const auto& bounds = set.elements.bounds;
    mask_.cover_box(other.elements.bounds, bounds.largest_radius, search.margin);
    if (set.size() / times_larger >= other.size()) mask_.cover_cells(other.elements.spheres);
    if (!mask_.covers_all_of(bounds)) keep_some(set, search.gather.workers);
  };
  leave_out_far(first_, second_);
  leave_out_far(second_, first_);
}

template <int Dim>
void JoinedSets<Dim>::place(const Set& set, std::size_t worker, std::size_t begin,
                            GatheredElements<Dim>& joined) {
  const std::size_t workers = set.counts.size();
  const std::size_t first = base::share_of(worker, workers, set.size()).first;
  const std::size_t count = set.counts[worker];
  std::size_t to = std::accumulate(set.counts.begin(),
                                   set.counts.begin() + static_cast<std::ptrdiff_t>(worker), begin);
  const bool all = set.count == set.size();
  const base::Sphere<Dim>* const spheres = set.elements.spheres.data();
  const bool boxes = !set.elements.boxes.empty();
  grid::Bounds<Dim>& bounds = joined.parts[worker];
  for (std::size_t k = first; k < first + count; ++k, ++to) {
    const std::size_t number = all ? k : set.kept[k];
    joined.spheres[to] = spheres[number];
    if (boxes) joined.boxes[to] = set.elements.boxes[number];
    bounds.include_center(spheres[number]);
    bounds.include_radius(spheres[number].radius);
    if (!all_there_) numbers_[to] = static_cast<ElementIndex>(number);
  }
}

template <int Dim>
void JoinedSets<Dim>::join(std::size_t workers, GatheredElements<Dim>& joined) {
  all_there_ = first_.count == first_.size() && second_.count == second_.size();
  const std::size_t count = first_.count + second_.count;
  const bool boxes = !first_.elements.boxes.empty() || !second_.elements.boxes.empty();
  base::resize_for_overwrite(joined.spheres, count);
  base::resize_for_overwrite(joined.boxes, boxes ? count : 0);
  if (!all_there_) base::make_room(numbers_, count);
  joined.parts.assign(workers, {});
  base::for_each_worker(workers, [&](std::size_t worker) {
    place(first_, worker, 0, joined);
    place(second_, worker, first_.count, joined);
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
  if (spheres && search.open_space && first.size() > 0 && second.size() > 0) leave_out(search);
  join(search.gather.workers, joined);
}

template class JoinedSets<2>;
template class JoinedSets<3>;

}  // namespace abut::api
