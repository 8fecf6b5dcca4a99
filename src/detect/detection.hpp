#pragma once

#include "base/detection_context.hpp"
#include "base/memory_meter.hpp"
#include "base/pair_sink.hpp"
#include "elements/element_ids.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/joined_sets.hpp"
#include "engine/rows.hpp"
#include "grid/bounds.hpp"
#include "lists/cross_sink.hpp"
#include "lists/found_pairs.hpp"
#include "lists/image_neighbor_rows.hpp"
#include "lists/neighbor_rows.hpp"
#include "lists/order_pairs.hpp"
#include "lists/rule_sink.hpp"
#include "lists/visiting_sink.hpp"
#include "periodic/periodic_workspace.hpp"
#include "skin/skin_choice.hpp"
#include "skin/skin_search.hpp"

#include <abut/detect.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/skin.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::api {

/// What is asked for.
struct Request {
  const ElementView& elements;
  const Domain& domain;
  const Options& options;
  const ElementView* others = nullptr;  ///< the second set, where there are two
  bool needs_shifts = false;            ///< whatever the options say
  LentRoom list_room = {};              ///< for pairs that may be found in canonical order

  /// Of both sets.
  [[nodiscard]] std::size_t size() const noexcept {
    return elements.size() + (others == nullptr ? 0 : others->size());
  }
};

/// The arrays of a neighbor list, to be filled: those not asked for are left empty.
struct NeighborArrays {
  NeighborList::Offsets& offsets;
  NeighborList::Neighbors& neighbors;
  ShiftArray& shifts;
  NeighborList::Distances& distances;
  NeighborList::Vectors& vectors;
};

/// The arrays of a detection and its course; kept by a Detector, or used once by a free function.
class Detection {
 public:
  Detection() = default;
  Detection(const Detection&) = delete;
  Detection& operator=(const Detection&) = delete;

  /// `shifts` is left empty unless the options ask for them.
  Statistics list_pairs(const Request& request, PairArray& pairs, ShiftArray& shifts);

  Statistics visit_batches(const Request& request, const Visitors& visitors);

  Statistics list_neighbors(const Request& request, NeighborListKind kind,
                            const NeighborArrays& arrays);

  /// For the calls that follow: candidate pairs are kept from call to call, and what is delivered
  /// comes in canonical order.
  void set_skin(Skin skin);
  /// Names of the elements in the calls that follow; copied. None: their numbers.
  void set_ids(std::span<const std::uint64_t> ids);
  [[nodiscard]] Skin skin() const noexcept { return skin_choice_.skin(); }
  [[nodiscard]] const SkinStatistics& skin_statistics() const noexcept { return skin_statistics_; }

 private:
  template <int Dim>
  struct Arrays {
    explicit Arrays(base::MemoryMeter& memory)
        : elements(memory),
          elements_aside(memory),
          sets(memory),
          workspace(memory),
          periodic_workspace(memory),
          skin_search(memory) {}

    GatheredElements<Dim> elements;
    GatheredElements<Dim> elements_aside;  ///< those of a call, while others are searched
    JoinedSets<Dim> sets;
    engine::Workspace<Dim> workspace;
    engine::PeriodicWorkspace<Dim> periodic_workspace;
    SkinSearch<Dim> skin_search;
  };

  template <int Dim>
  [[nodiscard]] Arrays<Dim>& arrays() noexcept {
    if constexpr (Dim == 2) {
      return in_2d_;
    } else {
      return in_3d_;
    }
  }

  Statistics run(const Request& request, base::PairSink& sink, base::DetectionContext& context);
  template <int Dim>
  Statistics run_in(const Request& request, base::PairSink& sink, base::DetectionContext& context);
  template <int Dim>
  void gather(const engine::RowsSettings& settings, const Request& request,
              base::DetectionContext& context);
  template <int Dim>
  void search_sets(const engine::RowsSettings& settings, const Request& request,
                   base::PairSink& sink, base::DetectionContext& context, Statistics& statistics);
  template <int Dim>
  void search(const engine::RowsSettings& settings, const Request& request, base::PairSink& sink,
              base::DetectionContext& context, Statistics& statistics);
  /// The same by candidates that are kept, where there is a skin.
  template <int Dim>
  void search_with_skin(const engine::RowsSettings& settings, const Request& request,
                        base::PairSink& sink, base::DetectionContext& context,
                        Statistics& statistics);
  template <int Dim>
  [[nodiscard]] bool find_candidates(const Snapshot<Dim>& now, const engine::RowsSettings& settings,
                                     const Request& request, base::DetectionContext& context,
                                     Statistics& statistics);
  /// Whether the candidates that are kept serve for this call, carried over if elements changed.
  template <int Dim>
  [[nodiscard]] bool has_candidates(const engine::RowsSettings& settings, const Request& request,
                                    base::DetectionContext& context);
  template <int Dim>
  void search_insertion(const engine::RowsSettings& settings, const Request& request,
                        const typename SkinSearch<Dim>::Insertion& insertion,
                        base::DetectionContext& context);
  template <int Dim>
  [[nodiscard]] Snapshot<Dim> snapshot(const engine::RowsSettings& settings,
                                       const Request& request);
  void require_ids_for(const Request& request) const;
  [[nodiscard]] NamedElements name_elements(std::size_t count);

  void list_rows(const Request& request, NeighborListKind kind, PairPieces pieces,
                 const NeighborArrays& arrays, std::size_t workers);
  void measure_rows(const Request& request, const NeighborArrays& arrays, std::size_t workers);
  template <int Dim>
  void measure_rows_in(const Request& request, const NeighborArrays& arrays, std::size_t workers);

  /// Sets the scene for `body(context)` and turns lack of memory into an Error.
  template <class Body>
  Statistics guarded(const Request& request, Body&& body);

  /// Finds the pairs, the first ones in `lent` if that can be, then has `arrange(pieces, workers)`
  /// lay them into the caller's arrays.
  template <class Arrange>
  Statistics find_and_arrange(const Request& request, LentRoom lent, Arrange&& arrange);

  base::MemoryMeter memory_;
  Arrays<2> in_2d_{memory_};
  Arrays<3> in_3d_{memory_};
  FoundPairs found_{memory_};
  VisitingSink visiting_;
  RuleSink ruling_;
  CrossSink crossing_;
  PairOrder order_{memory_};
  bool found_in_order_ = false;  ///< whether the search delivered in canonical order
  SkinChoice skin_choice_;
  SkinStatistics skin_statistics_;
  ElementIds ids_;
  ElementIds next_ids_;
  std::uint64_t ids_version_ = 0;
  Algorithm candidates_from_ = Algorithm::automatic;
  NeighborRows neighbor_rows_{memory_};
  RowRooms row_rooms_;
};

}  // namespace abut::api
