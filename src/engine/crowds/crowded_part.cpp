#include "engine/crowds/crowded_part.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace abut::engine {
namespace {

/// Spheres that lie in no near cache are fetched.
constexpr std::size_t fetched_ahead = 24;

/// A box of positions.
template <int Dim>
class PositionBox {
 public:
  void include(const kernels::PositionRecord& record) noexcept {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      lower_[axis] = std::min<std::int64_t>(lower_[axis], record.position[axis]);
      upper_[axis] = std::max<std::int64_t>(upper_[axis], record.position[axis]);
    }
  }
  /// Lets it reach so many units farther.
  void widen(std::int64_t units) noexcept {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      lower_[axis] -= units;
      upper_[axis] += units;
    }
  }
  [[nodiscard]] bool holds(const kernels::PositionRecord& record) const noexcept {
    bool holds = true;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const std::int64_t x = record.position[axis];
      holds = holds && lower_[axis] <= x && x <= upper_[axis];
    }
    return holds;
  }

 private:
  static std::array<std::int64_t, Dim> filled(std::int64_t value) noexcept {
    std::array<std::int64_t, Dim> all{};
    all.fill(value);
    return all;
  }

  std::array<std::int64_t, Dim> lower_ = filled(std::numeric_limits<std::int32_t>::max());
  std::array<std::int64_t, Dim> upper_ = filled(std::numeric_limits<std::int32_t>::min());
};

}  // namespace

template <int Dim>
CrowdedPart<Dim>::CrowdedPart(base::MemoryMeter& memory)
    : spheres_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      boxes_(base::make_array_for_overwrite<exact::Box<Dim>>(memory, 0)),
      given_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      marks_(given_) {}

template <int Dim>
void CrowdedPart<Dim>::take(const SearchInput<Dim>& input, const LayerGrid<Dim>& grid,
                            const LayerRecords<Dim>& records, const LayerCrowds<Dim>& crowds,
                            std::size_t k, base::WorkCounter& work) {
  list(grid, records, crowds, k, work);
  copy(input, work);
  numbers_.given = given_.data();
  numbers_.marks = marks_.data();
  numbers_.depth = input.part.depth + 1;
  numbers_.cell_around = grid.cell();
  numbers_.long_rows_around = grid.has_long_rows();
}

/// Lists the elements by their numbers in the set that is searched.
template <int Dim>
void CrowdedPart<Dim>::list(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records,
                            const LayerCrowds<Dim>& crowds, std::size_t k,
                            base::WorkCounter& work) {
  const std::size_t begin_layer = k == 0 ? 0 : k - 1;
  const std::size_t end_layer = std::min<std::size_t>(k + 2, grid.layer_count());
  std::size_t most = 0;
  for (std::size_t n = begin_layer; n < end_layer; ++n) most += records.layer(n).records.size();
  have_spheres_ = records.has_spheres();
  base::make_room(given_, most);
  if (have_spheres_) base::make_room(spheres_, most);
  size_ = 0;
  const auto list_if = [&](std::size_t n, const auto& is_meant) {
    const LayerElements<Dim> layer = records.layer(n);
    work.in_pieces(0, layer.records.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        if (!is_meant(layer.records[r])) continue;
        if (have_spheres_) spheres_[size_] = layer.spheres[r];
        given_[size_++] = layer.records[r].number;
      }
    });
  };
  PositionBox<Dim> box;
  list_if(k, [&](const kernels::PositionRecord& record) {
    const bool is_crowd = crowds.in_layer(k).hold(grid, record);
    if (is_crowd) box.include(record);
    return is_crowd;
  });
  crowd_ = size_;
  box.widen(grid.units_in_reach());
  for (std::size_t n = begin_layer; n < end_layer; ++n) {
    list_if(n, [&](const kernels::PositionRecord& record) {
      return box.holds(record) && (n > k || !crowds.in_layer(n).hold(grid, record));
    });
  }
}

/// Copies the elements that are listed.
template <int Dim>
void CrowdedPart<Dim>::copy(const SearchInput<Dim>& input, base::WorkCounter& work) {
  const PartNumbers& part = input.part;
  if (!have_spheres_) base::make_room(spheres_, size_);
  base::make_room(marks_, size_);
  have_boxes_ = input.spheres.stand_for_boxes();
  if (have_boxes_) base::make_room(boxes_, size_);
  bounds_ = {};
  numbers_.used_marks = 0;
  common_marks_ = ~std::uint32_t{0};
  work.in_pieces(0, size_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t number = given_[k];
      if (!have_spheres_) {
        if (k + fetched_ahead < size_) input.spheres.fetch(given_[k + fetched_ahead]);
        spheres_[k] = input.spheres[number];
      }
      exact::Sphere<Dim>& sphere = spheres_[k];
      if (have_boxes_) {
        boxes_[k] = kernels::box_at<Dim>(input.spheres.boxes(), number);
        sphere.radius = input.spheres.radius(number);
      }
      bounds_.include_center(sphere);
      bounds_.include_radius(sphere.radius);
      given_[k] = part.is_part() ? part.given[number] : number;
      marks_[k] = part.is_part() ? part.marks[number] : 0;
      if (k >= crowd_) marks_[k] |= part.free_mark();
      numbers_.used_marks |= marks_[k];
      common_marks_ &= marks_[k];
    }
  });
  if (have_boxes_) bounds_.count_largest_twice();
}

template <int Dim>
SearchInput<Dim> CrowdedPart<Dim>::input(const SearchInput<Dim>& whole,
                                         base::PairSink& sink) const {
  const std::span spheres(spheres_.data(), size_);
  const std::span boxes(boxes_.data(), have_boxes_ ? size_ : 0);
  return {{spheres, boxes},
          LayerSpheres<Dim>(kernels::SphereParts(kernels::strided_spheres(spheres)))
              .standing_for(kernels::strided_boxes(boxes)),
          {},
          whole.decider,
          whole.margin,
          whole.least_cell,
          whole.kernels,
          whole.element_kernels,
          whole.layer_kernels,
          whole.plane_kernels,
          whole.wide_vectors,
          whole.layer_limits.of_parts(),
          sink,
          whole.progress,
          numbers_};
}

template <int Dim>
SearchSet<Dim> CrowdedPart<Dim>::set() const {
  SearchSet<Dim> set;
  set.locals = Numbers(size_);
  set.bounds = bounds_;
  return set;
}

template class CrowdedPart<2>;
template class CrowdedPart<3>;

}  // namespace abut::engine
