#include "engine/divide.hpp"

#include "engine/catchment.hpp"
#include "engine/sphere_block.hpp"
#include "grid/kernel_bounds.hpp"

#include <algorithm>
#include <cstdint>

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

template <class Body>
void for_each_number(const Numbers& numbers, base::WorkCounter& work, Body&& body) {
  work.in_pieces(0, numbers.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) body(numbers[k]);
  });
}

/// The box of some elements and their radii.
template <int Dim>
grid::Bounds<Dim> bounds_of(const base::Elements<Dim>& elements, const Numbers& numbers,
                            const kernels::ElementKernels& kernels, base::WorkCounter& work) {
  grid::Bounds<Dim> bounds;
  SphereBlock<Dim> block;
  SphereBlock<Dim>::for_each(0, numbers.size(), [&](std::size_t begin, std::size_t end) {
    const auto spheres = block.of(elements.spheres, numbers, begin, end);
    std::size_t k = widen(bounds, [&](kernels::ElementBounds& packed) {
      return kernels.bound(spheres[0].center, spheres.size(), Dim, packed);
    });
    for (; k < spheres.size(); ++k) {
      bounds.include_center(spheres[k]);
      bounds.include_radius(spheres[k].radius);
    }
    work.did(end - begin);
  });
  return bounds;
}

}  // namespace

template <int Dim>
Group<Dim> group_of(const base::Elements<Dim>& elements, const Members& members, Wanted wanted,
                    const kernels::ElementKernels& kernels, base::WorkCounter& work) {
  Group<Dim> group;
  group.natives = Members::numbers(members.natives);
  group.foreigns = Members::numbers(members.foreigns);
  group.visitors = Members::numbers(members.visitors);
  group.wanted = wanted;
  group.bounds = bounds_of(elements, group.natives, kernels, work);
  work.in_pieces(0, group.foreigns.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      group.bounds.include_radius(elements[group.foreigns[k]].radius);
    }
  });
  if (elements.are_boxes()) group.bounds.count_largest_twice();
  return group;
}

template <int Dim>
void divide_by_size(const base::Elements<Dim>& elements, const Group<Dim>& group, double cut,
                    Floor<Dim>& floor, base::WorkCounter& work) {
  Members& large = floor.large;
  Members& small = floor.small;
  Members& across = floor.across;
  large.clear();
  small.clear();
  across.clear();
  for_each_number(group.visitors, work, [&](std::uint32_t number) {
    large.visitors.push_back(number);
    small.visitors.push_back(number);
  });
  const bool with_natives = group.wanted == Wanted::all_pairs;
  for_each_number(group.natives, work, [&](std::uint32_t number) {
    const bool is_small = elements[number].radius < cut;
    (is_small ? small : large).natives.push_back(number);
    if (!is_small && with_natives) {
      small.visitors.push_back(number);
      across.visitors.push_back(number);
    }
  });
  for_each_number(group.foreigns, work, [&](std::uint32_t number) {
    if (elements[number].radius < cut) {
      small.foreigns.push_back(number);
      across.natives.push_back(number);
    } else {
      large.foreigns.push_back(number);
      small.visitors.push_back(number);
    }
  });
}

template <int Dim>
Group<Dim> collect_tile(const base::Elements<Dim>& elements, const Tiles<Dim>& tiles,
                        std::size_t tile, double cell_size, double margin,
                        const kernels::ElementKernels& kernels, Members& members,
                        base::WorkCounter& work) {
  const std::span<const base::Sphere<Dim>> spheres = elements.spheres;
  const auto records = tiles.records(tile);
  const std::size_t own = tiles.own_count(tile);
  members.clear();
  members.natives.resize(own);
  work.in_pieces(0, own, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) members.natives[k] = records[k].number;
  });
  grid::Bounds<Dim> bounds = bounds_of(elements, Members::numbers(members.natives), kernels, work);
  const double wider = margin + position_slack * cell_size;
  const std::span<const std::uint32_t> visitors = tiles.visitors(tile);
  for_each_number({visitors.data(), visitors.size()}, work, [&](std::uint32_t number) {
    if (Catchment<Dim>::of(elements, number, bounds.largest_radius, wider).meets(bounds)) {
      members.visitors.push_back(number);
    }
  });
  work.in_pieces(own, records.size(), [&](std::size_t begin, std::size_t end) {
    for (const Record<Dim>& record : records.subspan(begin, end - begin)) {
      if (!within(spheres[record.number], bounds, cell_size)) continue;
      members.foreigns.push_back(record.number);
      bounds.include_radius(spheres[record.number].radius);
    }
  });
  if (elements.are_boxes()) bounds.count_largest_twice();
  return {Members::numbers(members.natives),
          Members::numbers(members.foreigns),
          Members::numbers(members.visitors),
          Wanted::all_pairs,
          1.0,
          bounds};
}

template Group<2> group_of(const base::Elements<2>&, const Members&, Wanted,
                           const kernels::ElementKernels&, base::WorkCounter&);
template Group<3> group_of(const base::Elements<3>&, const Members&, Wanted,
                           const kernels::ElementKernels&, base::WorkCounter&);
template void divide_by_size(const base::Elements<2>&, const Group<2>&, double, Floor<2>&,
                             base::WorkCounter&);
template void divide_by_size(const base::Elements<3>&, const Group<3>&, double, Floor<3>&,
                             base::WorkCounter&);
template Group<2> collect_tile(const base::Elements<2>&, const Tiles<2>&, std::size_t, double,
                               double, const kernels::ElementKernels&, Members&,
                               base::WorkCounter&);
template Group<3> collect_tile(const base::Elements<3>&, const Tiles<3>&, std::size_t, double,
                               double, const kernels::ElementKernels&, Members&,
                               base::WorkCounter&);

}  // namespace abut::engine
