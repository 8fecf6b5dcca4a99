#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/search_set.hpp"
#include "engine/tiles/record.hpp"
#include "engine/tiles/tile_grid.hpp"
#include "exact/elements.hpp"
#include "kernels/tiles/tile_view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// The elements of a search set sorted by tile, in each tile first its own, then the copies of
/// others. It keeps its memory from search set to search set.
///
///   records  | own of tile 0 | copies | own of tile 1 | copies | ...
///   begin[t] ^               ^ begin[t] + own[t]
///
///   coarse elements | of tile 0 | of tile 1 | ...          numbers of elements
///            ^ coarse_begin[t]
template <int Dim>
class Tiles {
 public:
  explicit Tiles(base::MemoryMeter& memory);

  /// The first of two passes over locals and halo elements, each shared by the workers: returns the
  /// number of records, own and copies, that the tiles would have.
  [[nodiscard]] std::uint64_t count(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                                    const TileGrid<Dim>& grid,
                                    const kernels::ElementKernels& kernels, std::size_t workers,
                                    base::WorkCounter& work);
  /// The second pass, after the first one with the same arguments.
  void sort(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
            const TileGrid<Dim>& grid, double margin, const kernels::ElementKernels& kernels,
            std::size_t workers, base::WorkCounter& work);

  [[nodiscard]] std::span<const Record<Dim>> records(std::size_t tile) const noexcept {
    return std::span(records_).subspan(begin_[tile], begin_[tile + 1] - begin_[tile]);
  }
  [[nodiscard]] kernels::ElementShape shape() const noexcept { return shape_; }
  /// Sizes of the records of a tile in its unit, record by record; the shape says which these are.
  [[nodiscard]] std::span<const float> sizes(std::size_t tile) const noexcept {
    return std::span(sizes_).subspan(begin_[tile] * size_columns_,
                                     (begin_[tile + 1] - begin_[tile]) * size_columns_);
  }
  [[nodiscard]] std::size_t own_count(std::size_t tile) const noexcept { return own_[tile]; }
  [[nodiscard]] std::span<const std::uint32_t> coarse_elements(std::size_t tile) const noexcept {
    if (!has_coarse_) return {};
    return std::span(coarse_).subspan(coarse_begin_[tile],
                                      coarse_begin_[tile + 1] - coarse_begin_[tile]);
  }
  /// Recorder::unit.
  [[nodiscard]] double unit() const noexcept { return unit_; }

 private:
  /// The part of one of the workers in a pass over all elements.
  struct Share {
    std::size_t worker;
    std::size_t workers;
    base::WorkCounter& work;
  };

  /// Next places that one worker writes to, each by tile.
  struct Cursors {
    std::uint64_t* own;
    std::uint64_t* halo_of_tiles;
    std::uint64_t* halo;
  };

  /// The numbers of records of a tile.
  struct TileCounts {
    std::uint64_t own = 0;
    std::uint64_t copies = 0;
  };

  [[nodiscard]] TileCounts counts_of(std::size_t tile, std::size_t tile_count,
                                     std::size_t workers) noexcept;
  [[nodiscard]] Cursors cursors_of(std::size_t worker, std::size_t tile_count) noexcept {
    std::uint64_t* const own = cursors_.data() + 3 * worker * tile_count;
    return {own, own + tile_count, own + 2 * tile_count};
  }

  void count_locals(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                    const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels,
                    const Share& share);
  void count_halo(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                  const TileGrid<Dim>& grid, const Share& share);
  void place(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
             const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels, std::size_t first,
             std::size_t last, base::WorkCounter& work);
  void lay_out(std::size_t tile_count, std::size_t workers);
  void scatter(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
               const TileGrid<Dim>& grid, const kernels::ElementKernels& kernels,
               std::size_t workers, base::WorkCounter& work);
  void scatter_locals(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                      const TileGrid<Dim>& grid, const Recorder<Dim>& recorder,
                      const kernels::ElementKernels& kernels, const Share& share);
  void record_one_tile(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                       const Recorder<Dim>& recorder, const kernels::ElementKernels& kernels,
                       std::size_t first, std::size_t last, std::uint64_t own,
                       base::WorkCounter& work);
  void note_sizes(const exact::Elements<Dim>& elements, std::uint32_t number,
                  const exact::Sphere<Dim>& sphere, const Recorder<Dim>& recorder,
                  std::uint64_t record);
  void scatter_halo(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                    const TileGrid<Dim>& grid, const Recorder<Dim>& recorder, const Share& share);
  void list_coarse(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set,
                   const TileGrid<Dim>& grid, double margin, base::WorkCounter& work);

  base::Array<std::uint32_t> places_;  ///< of the locals, then of the halo elements
  /// For each worker and tile: the number of own elements, copies of locals, and copies of halo
  /// elements that it finds; afterwards the place of the next one.
  base::Array<std::uint64_t> cursors_;
  base::Array<std::uint32_t> own_;
  base::Array<std::uint64_t> begin_;                  ///< tile_count + 1
  base::Array<std::array<double, Dim>> coordinates_;  ///< of the tiles, along the axes
  base::Array<Record<Dim>> records_;
  base::Array<float> sizes_;                 ///< of the records
  base::Array<std::uint64_t> coarse_begin_;  ///< tile_count + 1
  base::Array<std::uint32_t> coarse_;
  bool has_coarse_ = false;
  bool one_tile_ = false;
  kernels::ElementShape shape_ = kernels::ElementShape::equal_spheres;
  std::size_t size_columns_ = 0;
  double unit_ = 1.0;
};

}  // namespace abut::engine
