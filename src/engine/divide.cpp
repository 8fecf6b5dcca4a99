#include "engine/divide.hpp"

#include "engine/query_box.hpp"
#include "engine/sphere_block.hpp"
#include "grid/kernel_bounds.hpp"

#include <algorithm>
#include <cstdint>

namespace abut::engine {
namespace {

template <int Dim>
bool within(const exact::Sphere<Dim>& sphere, const grid::Bounds<Dim>& box, double distance) {
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
grid::Bounds<Dim> bounds_of(const exact::Elements<Dim>& elements, const Numbers& numbers,
                            const kernels::ElementKernels& kernels, base::WorkCounter& work) {
  grid::Bounds<Dim> bounds;
  SphereBlock<Dim> block;
  SphereBlock<Dim>::for_each(0, numbers.size(), [&](std::size_t begin, std::size_t end) {
    const auto spheres = block.of(elements.spheres, numbers, begin, end);
    std::size_t k = grid::widen(bounds, [&](kernels::ElementBounds& packed) {
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

/// Lists the coarse elements that reach the bounds of a set.
template <int Dim>
void list_coarse(const exact::Elements<Dim>& elements, const Numbers& coarse_elements,
                 const grid::Bounds<Dim>& bounds, double wider, Members& members,
                 base::WorkCounter& work) {
  for_each_number(coarse_elements, work, [&](std::uint32_t number) {
    if (QueryBox<Dim>::of(elements, number, bounds.largest_radius, wider).meets(bounds)) {
      members.coarse_elements.push_back(number);
    }
  });
}

}  // namespace

template <int Dim>
SearchSet<Dim> search_set_of(const exact::Elements<Dim>& elements, Members& members, Wanted wanted,
                             double wider, const kernels::ElementKernels& kernels,
                             base::WorkCounter& work) {
  SearchSet<Dim> set;
  set.locals = members.locals.numbers();
  set.halo = members.halo.numbers();
  set.wanted = wanted;
  set.bounds = bounds_of(elements, set.locals, kernels, work);
  for_each_number(set.halo, work, [&](std::uint32_t number) {
    set.bounds.include_radius(elements[number].radius);
  });
  const Numbers coarse_elements = members.coarse_elements.numbers();
  members.coarse_elements.clear();
  list_coarse(elements, coarse_elements, set.bounds, wider, members, work);
  set.coarse_elements = members.coarse_elements.numbers();
  if (elements.are_boxes()) set.bounds.count_largest_twice();
  return set;
}

template <int Dim>
SizeCounts count_by_size(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                         double cut, base::WorkCounter& work) {
  const auto small_ones = [&](const Numbers& numbers) {
    std::size_t count = 0;
    for_each_number(numbers, work, [&](std::uint32_t number) {
      count += static_cast<std::size_t>(elements[number].radius < cut);
    });
    return count;
  };
  const std::size_t small_locals = small_ones(set.locals);
  const std::size_t small_halo = small_ones(set.halo);
  const std::size_t large_locals = set.locals.size() - small_locals;
  const std::size_t large_halo = set.halo.size() - small_halo;
  const std::size_t coarse = set.coarse_elements.size();
  return {{large_locals, large_halo, coarse},
          {small_locals, small_halo, coarse + large_locals + large_halo},
          {small_halo, 0, large_locals}};
}

template <int Dim>
void divide_by_size(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set, double cut,
                    const SizeParts& division, base::WorkCounter& work) {
  Members& large = division.large;
  Members& small = division.small;
  Members& across = division.across;
  for_each_number(set.coarse_elements, work, [&](std::uint32_t number) {
    large.coarse_elements.push_back(number);
    small.coarse_elements.push_back(number);
  });
  const bool with_locals = set.wanted == Wanted::all_pairs;
  for_each_number(set.locals, work, [&](std::uint32_t number) {
    const bool is_small = elements[number].radius < cut;
    (is_small ? small : large).locals.push_back(number);
    if (!is_small && with_locals) {
      small.coarse_elements.push_back(number);
      across.coarse_elements.push_back(number);
    }
  });
  for_each_number(set.halo, work, [&](std::uint32_t number) {
    if (elements[number].radius < cut) {
      small.halo.push_back(number);
      across.locals.push_back(number);
    } else {
      large.halo.push_back(number);
      small.coarse_elements.push_back(number);
    }
  });
}

template <int Dim>
SearchSet<Dim> collect_tile(const exact::Elements<Dim>& elements, const Tiles<Dim>& tiles,
                            std::size_t tile, double cell_size, double margin,
                            const kernels::ElementKernels& kernels, Members& members,
                            base::WorkCounter& work) {
  const std::span<const exact::Sphere<Dim>> spheres = elements.spheres;
  const auto records = tiles.records(tile);
  const std::size_t own = tiles.own_count(tile);
  work.in_pieces(0, own, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) members.locals.push_back(records[k].number);
  });
  grid::Bounds<Dim> bounds = bounds_of(elements, members.locals.numbers(), kernels, work);
  const std::span<const std::uint32_t> coarse = tiles.coarse_elements(tile);
  list_coarse(elements, {coarse.data(), coarse.size()}, bounds, margin + position_slack * cell_size,
              members, work);
  work.in_pieces(own, records.size(), [&](std::size_t begin, std::size_t end) {
    for (const Record<Dim>& record : records.subspan(begin, end - begin)) {
      if (!within(spheres[record.number], bounds, cell_size)) continue;
      members.halo.push_back(record.number);
      bounds.include_radius(spheres[record.number].radius);
    }
  });
  if (elements.are_boxes()) bounds.count_largest_twice();
  return {members.locals.numbers(),
          members.halo.numbers(),
          members.coarse_elements.numbers(),
          Wanted::all_pairs,
          1.0,
          bounds};
}

template SearchSet<2> search_set_of(const exact::Elements<2>&, Members&, Wanted, double,
                                    const kernels::ElementKernels&, base::WorkCounter&);
template SearchSet<3> search_set_of(const exact::Elements<3>&, Members&, Wanted, double,
                                    const kernels::ElementKernels&, base::WorkCounter&);
template SizeCounts count_by_size(const exact::Elements<2>&, const SearchSet<2>&, double,
                                  base::WorkCounter&);
template void divide_by_size(const exact::Elements<2>&, const SearchSet<2>&, double,
                             const SizeParts&, base::WorkCounter&);
template SizeCounts count_by_size(const exact::Elements<3>&, const SearchSet<3>&, double,
                                  base::WorkCounter&);
template void divide_by_size(const exact::Elements<3>&, const SearchSet<3>&, double,
                             const SizeParts&, base::WorkCounter&);
template SearchSet<2> collect_tile(const exact::Elements<2>&, const Tiles<2>&, std::size_t, double,
                                   double, const kernels::ElementKernels&, Members&,
                                   base::WorkCounter&);
template SearchSet<3> collect_tile(const exact::Elements<3>&, const Tiles<3>&, std::size_t, double,
                                   double, const kernels::ElementKernels&, Members&,
                                   base::WorkCounter&);

}  // namespace abut::engine
