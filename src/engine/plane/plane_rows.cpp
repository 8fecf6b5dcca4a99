#include "engine/plane/plane_rows.hpp"

#include <algorithm>
#include <array>

namespace abut::engine {
namespace {

using kernels::ElementShape;

/// One of so many elements tells how many candidates all have.
constexpr std::uint32_t elements_of_sample = 8;

/// Columns that an element looks ahead.
template <int Dim>
std::uint32_t span_of(const exact::Sphere<Dim>& sphere, const PlaneGrid<Dim>& grid) {
  if (grid.shape() != ElementShape::spheres) return grid.looked_ahead().widest;
  return grid.looked_ahead().of(grid.length(sphere.radius));
}

}  // namespace

template <int Dim>
void PlaneRows<Dim>::count(const exact::Elements<Dim>& elements, const PlaneGrid<Dim>& grid,
                           const kernels::PlaneKernels& kernels, base::WorkCounter& work) {
  const std::size_t columns = (std::size_t{grid.rows()} + 1) * grid.row_length();
  base::make_room(position_of_, Dim * elements.size());
  base::make_room(column_of_, elements.size());
  base::make_room(column_end_, columns);
  locate(elements.spheres, grid, kernels);
  std::uint32_t* const counts = column_end_.data();
  std::fill_n(counts, columns, 0u);
  for (std::size_t k = 0; k < elements.size(); ++k) ++counts[column_of_[k]];
  find_places(grid);
  work.did(elements.size());
}

/// Notes the positions and the columns of all elements.
template <int Dim>
void PlaneRows<Dim>::locate(std::span<const exact::Sphere<Dim>> spheres, const PlaneGrid<Dim>& grid,
                            const kernels::PlaneKernels& kernels) noexcept {
  const std::size_t count = spheres.size();
  std::array<float*, 3> of_axis{};
  for (std::size_t k = 0; k < Dim; ++k) of_axis[grid.axis(k)] = position_of_.data() + k * count;
  std::size_t done = kernels.locate(spheres.front().center, count, Dim, grid.map(), of_axis.data());
  for (; done < count; ++done) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      of_axis[axis][done] = grid.position(spheres[done].center, axis);
    }
  }
  const float* const along = position_of_.data();
  const float* const across = along + count;
  done = kernels.find_columns(along, across, count, grid.map(), column_of_.data());
  for (; done < count; ++done) column_of_[done] = grid.column(along[done], across[done]);
}

/// Turns counts into the first place of each column.
template <int Dim>
void PlaneRows<Dim>::find_places(const PlaneGrid<Dim>& grid) noexcept {
  std::uint32_t place = 0;
  std::uint32_t* column = column_end_.data();
  for (std::uint32_t row = 0; row <= grid.rows(); ++row) {
    for (std::uint32_t k = 1; k < grid.row_length(); ++k) {
      const std::uint32_t count = *column;
      *column++ = place;
      place += count;
    }
    if (row < grid.rows()) place += std::uint32_t{kernels::plane_padding};
    *column++ = place;
  }
}

template <int Dim>
double PlaneRows<Dim>::mean_met(const exact::Elements<Dim>& elements,
                                const PlaneGrid<Dim>& grid) const noexcept {
  std::uint64_t met = 0;
  std::size_t sampled = 0;
  for (std::size_t k = 0; k < elements.size(); k += elements_of_sample, ++sampled) {
    const std::uint32_t span = span_of(elements[k], grid);
    const std::uint32_t* const in_row = column_end_.data() + column_of_[k];
    const std::uint32_t* const in_next = in_row + grid.row_length();
    // Half of those in its own column are ahead of it.
    met += in_row[span + 1] - (in_row[0] + in_row[1]) / 2;
    met += in_next[span + 1] - *(in_next - span);
  }
  return static_cast<double>(met) / static_cast<double>(sampled);
}

template <int Dim>
void PlaneRows<Dim>::sort(const exact::Elements<Dim>& elements, const PlaneGrid<Dim>& grid,
                          base::WorkCounter& work) {
  lay_out(elements.size(), grid);
  scatter(elements.size());
  scatter_sizes(elements, grid);
  pad_rows();
  work.did(elements.size());
}

/// Gives the columns of the view their places.
template <int Dim>
void PlaneRows<Dim>::lay_out(std::size_t elements, const PlaneGrid<Dim>& grid) {
  const std::size_t size_columns = kernels::size_columns(grid.shape(), Dim);
  places_ = elements + std::size_t{grid.rows()} * kernels::plane_padding;
  base::make_room(positions_, (Dim + size_columns) * places_);
  base::make_room(numbers_, 2 * places_);
  view_.shape = grid.shape();
  for (std::size_t axis = 0; axis < Dim; ++axis) view_.center[axis] = position(axis);
  for (std::size_t k = 0; k < size_columns; ++k) view_.size[k] = size(k);
  view_.common_radius = grid.largest_radius();
  view_.number = number();
  view_.column = column();
  view_.column_end = column_end_.data();
  view_.rows = grid.rows();
  view_.row_length = grid.row_length();
  view_.looked_ahead = grid.looked_ahead();
  view_.has_few_hits = grid.has_few_hits();
}

/// Brings the elements to their places. The first place of a column becomes the one behind its
/// last.
template <int Dim>
void PlaneRows<Dim>::scatter(std::size_t elements) noexcept {
  const std::array<float*, 3> to{position(0), position(1), position(Dim - 1)};
  std::uint32_t* const numbers = number();
  std::uint32_t* const its_column = column();
  std::uint32_t* const next = column_end_.data();
  for (std::size_t k = 0; k < elements; ++k) {
    const std::uint32_t column = column_of_[k];
    const std::uint32_t place = next[column]++;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      to[axis][place] = position_of_[axis * elements + k];
    }
    numbers[place] = static_cast<std::uint32_t>(k);
    its_column[place] = column;
  }
}

/// Notes how large the elements at all places are.
template <int Dim>
void PlaneRows<Dim>::scatter_sizes(const exact::Elements<Dim>& elements,
                                   const PlaneGrid<Dim>& grid) noexcept {
  if (grid.shape() == ElementShape::equal_spheres) return;
  for (std::uint32_t row = 0; row < view_.rows; ++row) {
    const kernels::Run places = view_.row(row);
    for (std::uint32_t place = places.begin; place < places.end; ++place) {
      const std::uint32_t k = view_.number[place];
      if (grid.shape() == ElementShape::spheres) {
        size(0)[place] = grid.length(elements[k].radius);
        continue;
      }
      const exact::Box<Dim>& box = elements.boxes[k];
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        const std::size_t at = grid.axis(axis);
        size(axis)[place] = grid.length(box.upper[at] - box.lower[at]);
      }
    }
  }
}

/// Puts what is no element behind each row.
template <int Dim>
void PlaneRows<Dim>::pad_rows() noexcept {
  const std::size_t size_columns = kernels::size_columns(view_.shape, Dim);
  for (std::uint32_t row = 0; row < view_.rows; ++row) {
    const std::uint32_t end = view_.row(row).end;
    std::fill_n(position(0) + end, kernels::plane_padding, kernels::far_away);
    for (std::size_t k = 0; k < size_columns; ++k) {
      std::fill_n(size(k) + end, kernels::plane_padding, 0.0f);
    }
  }
}

template class PlaneRows<2>;
template class PlaneRows<3>;

}  // namespace abut::engine
