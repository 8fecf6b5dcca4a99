// Elements counted and scattered by layer, a block of records at a time, included once for each
// instruction set into the namespace of layer_search_simd.cpp.

using WordTag = hn::Rebind<std::int32_t, DoubleTag>;
constexpr WordTag words{};
constexpr std::size_t elements_at_once = hn::MaxLanes(DoubleTag());

/// Whole numbers of units from the lower bound of an axis on.
HWY_INLINE hn::Vec<WordTag> positions_on(int axis, Doubles coordinates, const PositionMap& map) {
  const Doubles from_lower = hn::Sub(coordinates, hn::Set(doubles, map.lower[axis]));
  return hn::DemoteTo(words, hn::Mul(from_lower, hn::Set(doubles, map.units_of_one)));
}

void count_layers(const double* coordinates, std::size_t count, const PositionMap& map,
                  std::uint64_t* counts) {
  std::size_t k = 0;
  for (; k + elements_at_once <= count; k += elements_at_once) {
    HWY_ALIGN std::int32_t position[elements_at_once];
    const Doubles some = hn::LoadU(doubles, coordinates + k);
    hn::Store(positions_on(map.layer_axis, some, map), words, position);
    for (const std::int32_t its : position) ++counts[layer_of(its, map)];
  }
  count_each_layer(coordinates + k, count - k, map, counts);
}

template <int Dim>
class LayerWriter {
 public:
  HWY_INLINE LayerWriter(const PositionMap& map, const kernels::StridedSpheres& spheres,
                         const RecordsByLayer& to)
      : map_(map), spheres_(spheres), to_(to) {}

  /// Returns how many elements it treated, whole vectors of them.
  template <class Centers>
  std::size_t scatter(const Centers& centers, std::size_t first, std::size_t count) const {
    HWY_ALIGN PositionRecord block[block_size];
    const std::size_t whole = count - count % elements_at_once;
    for (std::size_t k = 0; k < whole; k += block_size) {
      const std::size_t size = std::min(block_size, whole - k);
      make_records(centers, first + k, size, block);
      write(first + k, size, block);
    }
    return whole;
  }

 private:
  static constexpr std::size_t block_size = 128;

  /// In 2D the third position is 0.
  template <class Centers>
  HWY_INLINE void make_records(const Centers& centers, std::size_t first, std::size_t count,
                               PositionRecord* block) const {
    for (std::size_t k = 0; k < count; k += elements_at_once) {
      Doubles center[Dim];
      centers.load(first + k, center);
      auto position = [&](int axis) HWY_ATTR { return positions_on(axis, center[axis], map_); };
      const auto third = Dim == 2 ? hn::Zero(words) : position(Dim - 1);
      const auto number =
          hn::Add(hn::Iota(words, 0),
                  hn::Set(words, static_cast<std::int32_t>(to_.number_of_first + first + k)));
      hn::StoreInterleaved4(position(0), position(1), third, number, words, block[k].position);
    }
  }

  /// Records, with radii or sizes of boxes if there are some: a loop for each of these.
  HWY_INLINE void write(std::size_t first, std::size_t count, const PositionRecord* block) const {
    if (to_.widths != nullptr) {
      write_each(count, block, [&](std::uint64_t place, std::size_t k) {
        write_size(to_, place, BoxSize<Dim>(*to_.boxes, block[k].number, map_));
      });
    } else if (to_.radii != nullptr) {
      write_each(count, block, [&](std::uint64_t place, std::size_t k) {
        base::fetch_next_line(to_.radii + place);
        to_.radii[place] = length_in_units(spheres_.radius(first + k), map_);
      });
    } else {
      write_each(count, block, [](std::uint64_t, std::size_t) {});
    }
  }

  /// Calls visit(place, k) for each.
  template <class Visit>
  HWY_INLINE void write_each(std::size_t count, const PositionRecord* block,
                             const Visit& visit) const {
    for (std::size_t k = 0; k < count; ++k) {
      const std::int32_t position = block[k].position[map_.layer_axis];
      const std::uint64_t place = to_.cursors[layer_of(position, map_)]++;
      base::fetch_next_line(to_.records + place);
      to_.records[place] = block[k];
      visit(place, k);
    }
  }

  const PositionMap& map_;
  const kernels::StridedSpheres& spheres_;
  const RecordsByLayer& to_;
};

template <int Dim>
std::size_t scatter_in(const kernels::StridedSpheres& spheres, std::size_t first, std::size_t count,
                       const PositionMap& map, const RecordsByLayer& to) {
  const LayerWriter<Dim> layers(map, spheres, to);
  return with_centers<Dim>(
      spheres, [&](const auto& centers) { return layers.scatter(centers, first, count); });
}
