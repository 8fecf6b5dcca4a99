#include "engine/layers/sorted_layers.hpp"

#include <algorithm>

namespace abut::engine {
namespace {

/// Places behind the last element of a layer that vectors read.
constexpr std::size_t tail = kernels::row_padding + kernels::widest_vector;

/// Places before the first layer: a run of the next layer is read from up to a vector before its
/// begin on, where it is joined with another run.
constexpr std::size_t lead = kernels::widest_vector;

template <int Dim>
kernels::PositionRecord no_element(const LayerGrid<Dim>& grid) {
  kernels::PositionRecord record{};
  record.position[grid.row_axis()] = grid.far_position();
  return record;
}

}  // namespace

template <int Dim>
SortedLayers<Dim>::SortedLayers(base::MemoryMeter& memory)
    : tables_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      entry_of_(tables_),
      placed_(base::make_array_for_overwrite<kernels::PositionRecord>(memory, 0)),
      positions_(base::make_array_for_overwrite<std::int32_t>(memory, 0)),
      numbers_(tables_),
      columns_(tables_),
      radii_(base::make_array_for_overwrite<float>(memory, 0)),
      widths_(base::make_array_for_overwrite<float>(memory, 0)),
      copies_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)) {}

template <int Dim>
void SortedLayers<Dim>::lay_out(const LayerGrid<Dim>& grid, std::size_t largest_layer) noexcept {
  const std::size_t rows = grid.row_count();
  parts_ = grid.is_by_size() ? 3 : 2;
  part_ = largest_layer + rows * kernels::row_padding + tail + kernels::widest_vector;
  row_length_ = grid.column_count() + 2 * grid.columns_in_reach() + 2;
  table_size_ = (rows + 2) * row_length_;
}

template <int Dim>
std::size_t SortedLayers<Dim>::integers_for(const LayerGrid<Dim>& grid,
                                            std::size_t largest_layer) noexcept {
  lay_out(grid, largest_layer);
  constexpr std::size_t integers_of_place = sizeof(kernels::PositionRecord) / sizeof(std::uint32_t);
  constexpr std::size_t integers_of_copy = sizeof(exact::Sphere<Dim>) / sizeof(std::uint32_t);
  const std::size_t integers_of_sorted = 6 + (grid.has_widths() ? Dim : integers_of_copy);
  return parts_ * (table_size_ + part_ * integers_of_sorted) + largest_layer +
         part_ * integers_of_place;
}

template <int Dim>
void SortedLayers<Dim>::start(const LayerGrid<Dim>& grid, std::size_t largest_layer) {
  has_copies_ = {};
  lay_out(grid, largest_layer);
  base::make_room(tables_, parts_ * table_size_);
  base::make_room(entry_of_, largest_layer);
  base::make_room(placed_, part_);
  base::make_room(numbers_, lead + parts_ * part_);
  base::make_room(columns_, numbers_.size());
  if (grid.has_radii()) base::make_room(radii_, numbers_.size());
  base::make_room(positions_, 3 * numbers_.size());
  length_ = positions_.size() / 3;
  if (grid.has_widths()) base::make_room(widths_, Dim * length_);
}

template <int Dim>
void SortedLayers<Dim>::sort(const LayerGrid<Dim>& grid, std::size_t k,
                             const LayerElements<Dim>& elements,
                             const kernels::StridedSpheres* spheres,
                             const kernels::LayerKernels& kernels, base::WorkCounter& work) {
  std::uint32_t* const table = this->table(k);
  count(grid, table, elements.records, kernels, work);
  const auto begin = static_cast<std::uint32_t>(lead + k % parts_ * part_);
  const std::uint32_t end = lay_out_table(grid, table, begin, kernels);
  if (spheres != nullptr) base::make_room(copies_, lead + parts_ * part_);
  LayerElements<Dim> placed = elements;
  if (spheres == nullptr) placed.spheres = {};
  place(placed, table, begin, work);
  pad(grid, table, placed_.data() - begin, end);
  const std::size_t size = end - begin + tail;
  const kernels::LayerColumns columns{
      {positions_.data() + begin, positions_.data() + length_ + begin,
       positions_.data() + 2 * length_ + begin},
      numbers_.data() + begin,
      columns_.data() + begin,
      static_cast<int>(grid.row_axis()),
      grid.column_shift()};
  kernels.split(placed_.data(), size, columns);
  if (!grid.is_by_size()) has_copies_[k % 2] = spheres != nullptr;
  if (spheres != nullptr && elements.spheres.empty()) copy(*spheres, begin, size, work);
  work.did(size + table_size_);
}

/// Counts the records of each column, an entry further on than `lay_out_table` wants it.
template <int Dim>
void SortedLayers<Dim>::count(const LayerGrid<Dim>& grid, std::uint32_t* table,
                              std::span<const kernels::PositionRecord> records,
                              const kernels::LayerKernels& kernels, base::WorkCounter& work) {
  std::fill_n(table, table_size_, std::uint32_t{0});
  const kernels::EntryMap map =
      grid.entry_map(static_cast<std::uint32_t>(row_length_),
                     static_cast<std::uint32_t>(row_length_ + grid.columns_in_reach() + 1));
  work.in_pieces(0, records.size(), [&](std::size_t begin, std::size_t end) {
    kernels.count_entries(records.data() + begin, end - begin, map, entry_of_.data() + begin,
                          table);
  });
}

/// Turns counts into first places and returns the end of the layer. When its elements are placed,
/// an entry is the end of its column, which is the begin of the next one.
template <int Dim>
std::uint32_t SortedLayers<Dim>::lay_out_table(
    const LayerGrid<Dim>& grid, std::uint32_t* table, std::uint32_t begin,
    const kernels::LayerKernels& kernels) const noexcept {
  std::uint32_t place = begin;
  for (std::size_t row = 0; row < grid.row_count() + std::size_t{2}; ++row) {
    place = kernels.turn_into_places(table, row_length_, place);
    table += row_length_;
    if (row > 0 && row <= grid.row_count()) place += kernels::row_padding;
  }
  return place;
}

/// Brings the records into the order of their columns; radii or widths and spheres at once to where
/// they stay.
template <int Dim>
void SortedLayers<Dim>::place(const LayerElements<Dim>& elements, std::uint32_t* table,
                              std::uint32_t begin, base::WorkCounter& work) {
  kernels::PositionRecord* const placed = placed_.data();
  const auto place_all = [&](const auto&... place_more) {
    work.in_pieces(0, elements.records.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t r = first; r < last; ++r) {
        const std::uint32_t place = table[entry_of_[r]]++;
        placed[place - begin] = elements.records[r];
        (place_more(place, r), ...);
      }
    });
  };
  const auto radius = [&, radii = radii_.data()](std::uint32_t place, std::size_t r) {
    radii[place] = elements.radii[r];
  };
  const auto sphere = [&, copies = copies_.data()](std::uint32_t place, std::size_t r) {
    copies[place] = elements.spheres[r];
  };
  const auto width = [&](std::uint32_t place, std::size_t r) {
    for (std::size_t axis = 0; axis < Dim; ++axis) widths(axis)[place] = elements.widths[r][axis];
  };
  const bool has_radii = !elements.radii.empty();
  if (!elements.widths.empty()) return has_radii ? place_all(width, radius) : place_all(width);
  if (elements.spheres.empty()) return has_radii ? place_all(radius) : place_all();
  return has_radii ? place_all(radius, sphere) : place_all(sphere);
}

/// Copies spheres to the places of their records, padding those of anyone.
template <int Dim>
void SortedLayers<Dim>::copy(const kernels::StridedSpheres& spheres, std::uint32_t begin,
                             std::size_t size, base::WorkCounter& work) {
  constexpr std::size_t fetched_ahead = 48;
  work.in_pieces(0, size, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      if (k + fetched_ahead < size) kernels::fetch<Dim>(spheres, placed_[k + fetched_ahead].number);
      copies_[begin + k] = kernels::sphere_at<Dim>(spheres, placed_[k].number);
    }
  });
}

template <int Dim>
void SortedLayers<Dim>::pad(const LayerGrid<Dim>& grid, const std::uint32_t* table,
                            kernels::PositionRecord* placed, std::uint32_t end) noexcept {
  const kernels::PositionRecord none = no_element(grid);
  const auto put = [&](std::uint32_t place, std::size_t count) {
    std::fill_n(placed + place, count, none);
    if (grid.has_radii()) std::fill_n(radii_.data() + place, count, 0.0f);
    for (std::size_t axis = 0; grid.has_widths() && axis < Dim; ++axis) {
      std::fill_n(widths(axis) + place, count, 0.0f);
    }
  };
  for (std::size_t row = 1; row <= grid.row_count(); ++row) {
    put(table[(row + 1) * row_length_ - 1], kernels::row_padding);
  }
  put(end, tail);
}

template <int Dim>
kernels::LayerPair SortedLayers<Dim>::pair(const LayerGrid<Dim>& grid,
                                           std::size_t k) const noexcept {
  kernels::LayerPair layers{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    layers.position[axis] = positions_.data() + axis * length_;
  }
  layers.number = numbers_.data();
  layers.column = columns_.data();
  if (grid.has_radii()) layers.radius = radii_.data();
  for (std::size_t axis = 0; grid.has_widths() && axis < Dim; ++axis) {
    layers.width[axis] = widths_.data() + axis * length_;
  }
  layers.copies = has_copies_[0] && has_copies_[1] ? copies_.data()->center : nullptr;
  layers.own = table(k);
  layers.next = table(k + 1);
  layers.rows = grid.row_count();
  layers.row_length = static_cast<std::uint32_t>(row_length_);
  layers.end_of_run = 2 * grid.columns_in_reach() + 1;
  grid.set_reach(layers);
  return layers;
}

template <int Dim>
kernels::ThreeLayers SortedLayers<Dim>::layer_alone(const LayerGrid<Dim>& grid,
                                                    std::size_t k) const noexcept {
  kernels::ThreeLayers layers{};
  static_cast<kernels::LayerPair&>(layers) = pair(grid, k);
  layers.copies = nullptr;
  grid.set_layers(layers, k);
  return layers;
}

template <int Dim>
kernels::ThreeLayers SortedLayers<Dim>::three_layers(const LayerGrid<Dim>& grid,
                                                     std::size_t k) const noexcept {
  kernels::ThreeLayers layers = layer_alone(grid, k);
  layers.to_below = static_cast<std::int32_t>(table(before(k)) - layers.own);
  layers.to_next = static_cast<std::int32_t>(layers.next - layers.own);
  return layers;
}

template class SortedLayers<2>;
template class SortedLayers<3>;

}  // namespace abut::engine
