#pragma once

#include "base/pair_sink.hpp"
#include "base/progress_reporter.hpp"
#include "engine/crowds/part_numbers.hpp"
#include "engine/deciders/exact_decider.hpp"
#include "engine/layers/layer_limits.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "engine/worker_scratch.hpp"
#include "exact/elements.hpp"
#include "kernels/element_kernels.hpp"
#include "kernels/layers/layer_kernels.hpp"
#include "kernels/plane/plane_search.hpp"
#include "kernels/tiles/tile_search.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace abut::engine {

/// The spheres that decide, as they are given. Where all their coordinates are multiples of a power
/// of two, from `least_step` to `largest_step`, those that are searched were not rounded, but moved
/// by multiples of it. 0 as the largest step: they may have been rounded in any case.
struct GivenSteps {
  kernels::StridedSpheres spheres{};
  double least_step = 0.0;
  double largest_step = 0.0;
};

/// Arguments of a search, which all its workers share.
template <int Dim>
struct SearchInput {
  exact::Elements<Dim>
      elements;               ///< as the engine maps them; none where they are in `spheres` only
  LayerSpheres<Dim> spheres;  ///< the same where their numbers lie; stand-ins of boxes
  GivenSteps given;
  const ExactDecider& decider;  ///< of what single precision leaves open
  double margin;                ///< in the scale of `elements`
  double least_cell;            ///< positions are not known well enough for smaller
  kernels::TileKernels kernels;
  kernels::ElementKernels element_kernels;
  kernels::LayerKernels layer_kernels;
  kernels::PlaneKernels plane_kernels;
  kernels::WideVectors wide_vectors;
  LayerLimits layer_limits;
  base::PairSink& sink;
  base::ProgressReporter& progress;
  PartNumbers part = {};  ///< of elements that are a part of a larger set

  /// The spheres that decide, by the numbers of this set, if vectors decide on them.
  [[nodiscard]] const kernels::StridedSpheres* deciding_spheres() const noexcept {
    return part.is_part() ? nullptr : decider.spheres();
  }
};

/// One worker: sorts tiles and layers on its scratch, runs the kernels, decides what they leave
/// undecided, hands on pairs.
template <int Dim>
class SearchWorker {
 public:
  SearchWorker(base::MemoryMeter& memory, std::size_t worker);

  SearchWorker(const SearchWorker&) = delete;
  SearchWorker& operator=(const SearchWorker&) = delete;
  ~SearchWorker() = default;

  /// A new search; `input` must outlive it.
  void start(const SearchInput<Dim>& input);

  /// Pairs found from here on belong to this unit of the search.
  void begin_unit(std::uint64_t unit);
  /// Hands on the pairs found so far, which are all of the unit.
  void finish_unit();
  /// Hands on the pairs found so far.
  void hand_over();

  /// The worker, and the unit of the search to which its pairs belong.
  [[nodiscard]] const base::Origin& origin() const noexcept { return origin_; }

  /// Counts the tests and decisions of a search that was made for this worker.
  void count_in(std::uint64_t tests, std::uint64_t decisions) noexcept;

  [[nodiscard]] WorkerScratch<Dim>& scratch() noexcept { return *scratch_; }

  /// Frees its arrays, which no search needs any longer.
  void free_arrays();

  /// Counter of this worker's steps, through which the caller's hook is asked.
  [[nodiscard]] base::WorkCounter& work() noexcept { return work_; }

  /// Finds the pairs among the elements of the scratch's tile.
  void search(double unit);

  /// Finds the pairs of some layers of a tile, which may be another worker's. All layers one after
  /// the other give the pairs of the tile in the order of search().
  void search(const SortedTile<Dim>& tile, const kernels::Layers& layers, double unit);

  /// Finds the pairs among the elements of a plane.
  void search(const kernels::PlaneView& plane, double unit);

  /// Finds the pairs of a layer with itself and the next one.
  void search(const kernels::LayerPair& layers);

  /// Finds the smaller partners of the layer's near elements, and in this layer those of far ones.
  void search(const kernels::ThreeLayers& layers, std::span<const kernels::FarSphere> far);

  /// Finds the partners of coarse elements in the layer.
  void search_coarse(const kernels::ThreeLayers& layers,
                     std::span<const kernels::FarSphere> coarse);

  /// Decides on two elements.
  void test_pair(std::uint32_t first, std::uint32_t second);

  /// Tells whether most elements of the layer searched last had an undecided pair, as on lattices.
  [[nodiscard]] bool has_many_undecided() const noexcept { return job_.has_many_undecided; }

  /// Finds the pairs of the tile's own elements with the coarse elements.
  void test_coarse(const TileFrame<Dim>& frame, std::span<const std::uint32_t> coarse_elements);

  [[nodiscard]] std::uint64_t candidate_tests() const noexcept {
    return job_.candidate_tests + far_tests_;
  }
  [[nodiscard]] std::uint64_t exact_decisions() const noexcept { return exact_decisions_; }

 private:
  void prepare(const SortedTile<Dim>& tile, double unit);
  void take();
  void number_as_given();
  void settle();
  void hand_on();
  void flush();
  bool decide(std::uint32_t first, std::uint32_t second);
  void tell();
  void test_far_coarse(std::span<const kernels::Run> runs, std::uint32_t coarse);

  const SearchInput<Dim>* input_ = nullptr;
  base::MemoryMeter& memory_;
  std::optional<WorkerScratch<Dim>> scratch_;
  base::Origin origin_;
  kernels::SearchJob job_{};
  kernels::HitBuffer hits_;
  std::span<ContactPair> pairs_;  ///< the sink's room, and how much of it is filled
  std::size_t filled_ = 0;
  std::uint64_t far_tests_ = 0;
  std::uint64_t tests_told_ = 0;
  base::WorkCounter work_;
  std::uint64_t exact_decisions_ = 0;
};

}  // namespace abut::engine
