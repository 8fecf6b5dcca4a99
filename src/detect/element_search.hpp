#pragma once

#include "base/detection_context.hpp"
#include "base/memory_meter.hpp"
#include "base/pair_sink.hpp"
#include "elements/gathered_elements.hpp"
#include "engine/rows.hpp"
#include "engine/workspace.hpp"
#include "periodic/periodic_workspace.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/options.hpp>
#include <abut/statistics.hpp>

#include <cstddef>
#include <optional>

namespace abut::detect {

/// The settings of a search among gathered elements, and what it may use.
struct SearchTask {
  const Domain& domain;
  const Options& options;
  engine::RowsSettings settings;
};

/// Searches gathered elements with the algorithm that the options name or, for `auto`, leave to be
/// chosen. It keeps the memory of the algorithms from one search to the next.
template <int Dim>
class ElementSearch {
 public:
  explicit ElementSearch(base::MemoryMeter& memory)
      : memory_(memory), workspace_(memory), periodic_(memory) {}

  /// Delivers every contact pair once to `sink` and notes in `statistics` which algorithm ran, and
  /// how. A periodic search appends ghosts to the array of spheres and takes them away again, so
  /// that this array may lie elsewhere in memory afterwards.
  void search(elements::GatheredElements<Dim>& elements, const SearchTask& task,
              base::PairSink& sink, base::DetectionContext& context, Statistics& statistics);

  /// Does the same without a packed copy of the elements, where `rows` can and where the last
  /// search says that it will. Otherwise it delivers nothing and returns false. Throws at a bad
  /// element.
  [[nodiscard]] bool search_in_place(const ElementView& elements, const SearchTask& task,
                                     elements::GatheredElements<Dim>& room, base::PairSink& sink,
                                     base::DetectionContext& context, Statistics& statistics);

  /// Gives back what the algorithms have kept.
  void give_back_memory();

 private:
  /// Arguments of `search_in_place`.
  struct InPlaceCall {
    const ElementView& elements;
    const SearchTask& task;
    elements::GatheredElements<Dim>& room;
    base::PairSink& sink;
    base::DetectionContext& context;
    Statistics& statistics;
  };

  [[nodiscard]] bool may_next_be_in_place(std::size_t elements) const noexcept;
  void find_bounds(const InPlaceCall& call) const;
  [[nodiscard]] bool search_boxes_in_place(const InPlaceCall& call);
  [[nodiscard]] bool may_be_in_place(const ElementView& elements, const SearchTask& task) const;

  base::MemoryMeter& memory_;
  std::optional<engine::Workspace<Dim>> workspace_;
  std::optional<periodic::PeriodicWorkspace<Dim>> periodic_;
  /// What the last search says of the next one: it was in layers, or done in place. The first one
  /// is tried where there are many elements.
  std::optional<bool> next_may_be_in_place_;
};

}  // namespace abut::detect
