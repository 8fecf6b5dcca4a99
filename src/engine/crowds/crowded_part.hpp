#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/crowds/layer_crowds.hpp"
#include "engine/crowds/part_numbers.hpp"
#include "engine/search_set.hpp"
#include "engine/search_worker.hpp"
#include "exact/box.hpp"
#include "exact/sphere.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// The crowd of a layer as a search set of its own: copies of its elements, and of those around
/// that may meet them, which have a mark. A pair of two marked ones is found elsewhere, and so is
/// that of the crowd with the one of the layer before. It keeps its memory from part to part.
///
///   place    | the crowd | around it, marked: rest of this layer and of the one before, next one |
template <int Dim>
class CrowdedPart {
 public:
  explicit CrowdedPart(base::MemoryMeter& memory);

  /// Takes the crowd of layer k. There must be a free mark.
  void take(const SearchInput<Dim>& input, const LayerGrid<Dim>& grid,
            const LayerRecords<Dim>& records, const LayerCrowds<Dim>& crowds, std::size_t k,
            base::WorkCounter& work);

  /// The input of its search: that of the whole set, or of a part in which it lies, but for the
  /// elements and where pairs go.
  [[nodiscard]] SearchInput<Dim> input(const SearchInput<Dim>& whole, base::PairSink& sink) const;

  /// All its elements.
  [[nodiscard]] SearchSet<Dim> set() const;

  /// Parts that this one is a part of, and itself.
  [[nodiscard]] std::size_t depth() const noexcept { return numbers_.depth; }

  /// The number of elements of the crowd, and with those around it.
  [[nodiscard]] std::size_t crowd() const noexcept { return crowd_; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// Elements for which there is room without an allocation.
  [[nodiscard]] std::size_t room() const noexcept { return marks_.size(); }

  /// Tells whether it has pairs to find: there are none where all elements have a mark in common.
  [[nodiscard]] bool may_have_pairs() const noexcept { return common_marks_ == 0; }

 private:
  void list(const LayerGrid<Dim>& grid, const LayerRecords<Dim>& records,
            const LayerCrowds<Dim>& crowds, std::size_t k, base::WorkCounter& work);
  void copy(const SearchInput<Dim>& input, base::WorkCounter& work);

  base::Array<exact::Sphere<Dim>> spheres_;
  base::Array<exact::Box<Dim>> boxes_;
  base::Array<std::uint32_t> given_;  ///< numbers; in the set that is searched until all are copied
  base::Array<std::uint32_t> marks_;
  std::size_t size_ = 0;
  std::size_t crowd_ = 0;
  std::uint32_t common_marks_ = 0;
  bool have_boxes_ = false;
  bool have_spheres_ = false;  ///< those of the layer were sorted along
  PartNumbers numbers_;
  grid::Bounds<Dim> bounds_;
};

}  // namespace abut::engine
