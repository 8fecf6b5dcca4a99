#include "engine/divide.hpp"

#include "engine/catchment.hpp"

#include <algorithm>

namespace abut::engine {
namespace {

template <int Dim>
bool within(const base::Sphere<Dim>& sphere, const grid::Bounds<Dim>& box, double distance) {
  bool inside = true;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    inside = inside && box.lower[axis] - sphere.center[axis] <= distance &&
             sphere.center[axis] - box.upper[axis] <= distance;
  }
  return inside;
}

}  // namespace

template <int Dim>
Group<Dim> group_of(const base::Elements<Dim>& elements, const Members& members, Wanted wanted) {
  Group<Dim> group;
  group.natives = Members::numbers(members.natives);
  group.foreigns = Members::numbers(members.foreigns);
  group.visitors = Members::numbers(members.visitors);
  group.wanted = wanted;
  for (const std::uint32_t number : members.natives) {
    group.bounds.include_center(elements[number]);
    group.bounds.include_radius(elements[number].radius);
  }
  for (const std::uint32_t number : members.foreigns) {
    group.bounds.include_radius(elements[number].radius);
  }
  if (elements.are_boxes()) group.bounds.count_largest_twice();
  return group;
}

template <int Dim>
void divide_by_size(const base::Elements<Dim>& elements, const Group<Dim>& group, double cut,
                    Floor<Dim>& floor) {
  Members& large = floor.large;
  Members& small = floor.small;
  Members& across = floor.across;
  large.clear();
  small.clear();
  across.clear();
  for (std::size_t k = 0; k < group.visitors.size(); ++k) {
    large.visitors.push_back(group.visitors[k]);
    small.visitors.push_back(group.visitors[k]);
  }
  const bool with_natives = group.wanted == Wanted::all_pairs;
  for (std::size_t k = 0; k < group.natives.size(); ++k) {
    const std::uint32_t number = group.natives[k];
    const bool is_small = elements[number].radius < cut;
    (is_small ? small : large).natives.push_back(number);
    if (!is_small && with_natives) {
      small.visitors.push_back(number);
      across.visitors.push_back(number);
    }
  }
  for (std::size_t k = 0; k < group.foreigns.size(); ++k) {
    const std::uint32_t number = group.foreigns[k];
    if (elements[number].radius < cut) {
      small.foreigns.push_back(number);
      across.natives.push_back(number);
    } else {
      large.foreigns.push_back(number);
      small.visitors.push_back(number);
    }
  }
}

template <int Dim>
Group<Dim> collect_tile(const base::Elements<Dim>& elements, const Tiles<Dim>& tiles,
                        std::size_t tile, double cell_size, double margin, Members& members) {
  // Elements of a tile lie anywhere in memory.
  constexpr std::size_t fetched_ahead = 16;
  const std::span<const base::Sphere<Dim>> spheres = elements.spheres;
  const auto records = tiles.records(tile);
  const std::size_t own = tiles.own_count(tile);
  members.clear();
  members.natives.resize(own);
  grid::Bounds<Dim> bounds;
  for (std::size_t k = 0; k < own; ++k) {
    if (k + fetched_ahead < records.size()) {
      __builtin_prefetch(&spheres[records[k + fetched_ahead].number]);
    }
    const std::uint32_t number = records[k].number;
    members.natives[k] = number;
    bounds.include_center(spheres[number]);
    bounds.include_radius(spheres[number].radius);
  }
  const double wider = margin + position_slack * cell_size;
  for (const std::uint32_t number : tiles.visitors(tile)) {
    if (Catchment<Dim>::of(elements, number, bounds.largest_radius, wider).meets(bounds)) {
      members.visitors.push_back(number);
    }
  }
  for (const Record<Dim>& record : records.subspan(own)) {
    if (!within(spheres[record.number], bounds, cell_size)) continue;
    members.foreigns.push_back(record.number);
    bounds.include_radius(spheres[record.number].radius);
  }
  if (elements.are_boxes()) bounds.count_largest_twice();
  return {Members::numbers(members.natives),
          Members::numbers(members.foreigns),
          Members::numbers(members.visitors),
          Wanted::all_pairs,
          1.0,
          bounds};
}

template Group<2> group_of(const base::Elements<2>&, const Members&, Wanted);
template Group<3> group_of(const base::Elements<3>&, const Members&, Wanted);
template void divide_by_size(const base::Elements<2>&, const Group<2>&, double, Floor<2>&);
template void divide_by_size(const base::Elements<3>&, const Group<3>&, double, Floor<3>&);
template Group<2> collect_tile(const base::Elements<2>&, const Tiles<2>&, std::size_t, double,
                               double, Members&);
template Group<3> collect_tile(const base::Elements<3>&, const Tiles<3>&, std::size_t, double,
                               double, Members&);

}  // namespace abut::engine
