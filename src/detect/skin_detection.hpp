#pragma once

#include "base/by_dimension.hpp"
#include "base/detection_context.hpp"
#include "base/memory_meter.hpp"
#include "base/pair_sink.hpp"
#include "detect/detection_request.hpp"
#include "detect/element_search.hpp"
#include "detect/two_set_search.hpp"
#include "elements/element_ids.hpp"
#include "elements/gathered_elements.hpp"
#include "skin/elements_now.hpp"
#include "skin/skin_choice.hpp"
#include "skin/skin_search.hpp"

#include <abut/algorithm.hpp>
#include <abut/element_view.hpp>
#include <abut/skin.hpp>
#include <abut/statistics.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::detect {

/// One call on gathered elements, with the searches that a detection with a skin may need.
template <int Dim>
struct SkinCall {
  elements::GatheredElements<Dim>& elements;
  ElementSearch<Dim>& search;
  TwoSetSearch<Dim>& two_set_search;
  const SearchTask& task;
  base::DetectionContext& context;
  Statistics& statistics;
};

/// One call on elements as the caller gives them.
struct UngatheredCall {
  const ElementView& elements;
  const SearchTask& task;
  base::DetectionContext& context;
  Statistics& statistics;
};

/// Detections that keep candidate pairs from call to call (docs/derivations/skin.md): decides for
/// each call whether the kept ones serve, has them searched for where they do not, and delivers the
/// contacts among them. The searches are given to it.
class SkinDetection {
 public:
  explicit SkinDetection(base::MemoryMeter& memory)
      : arrays_{SkinArrays<2>(memory), SkinArrays<3>(memory)} {}

  /// Drops all candidates; the skin holds for the calls that follow.
  void set_skin(Skin skin);
  [[nodiscard]] Skin skin() const noexcept { return choice_.skin(); }

  /// Copies names of the elements for the calls that follow; without any, elements are identified
  /// by their index.
  void set_ids(std::span<const std::uint64_t> ids);

  /// Throws Error{invalid_input} where ids were given for another number of elements.
  void require_ids_for(std::size_t count) const;

  [[nodiscard]] const SkinStatistics& statistics() const noexcept { return statistics_; }
  void note_survivors(PairCount count) noexcept { statistics_.survivors = count; }

  /// Tells whether a skin was set and candidates are kept of such elements; of boxes none are.
  [[nodiscard]] bool applies_to(const DetectionRequest& request) const noexcept;

  /// Reads the elements, and tells whether deliver() can do without gathering them: where kept
  /// candidates serve as they are, and elements are in the order of space.
  template <int Dim>
  [[nodiscard]] bool prepare(const UngatheredCall& call);

  template <int Dim>
  void deliver(const UngatheredCall& call, base::PairSink& sink);

  /// Origin of the candidates that a call tests.
  enum class Source {
    none,          ///< none can be kept: the elements must be searched without a skin
    this_call,     ///< searched for in this call
    carried_over,  ///< kept, and taken over to elements that came, went or were renumbered
    earlier_call,  ///< kept as they are
  };

  /// Sees to it that there are candidates for this call, if that can be.
  template <int Dim>
  [[nodiscard]] Source prepare(const SkinCall<Dim>& call);

  /// Delivers the contacts among the candidates that were prepared, in canonical order.
  template <int Dim>
  void deliver(const SkinCall<Dim>& call, Source source, base::PairSink& sink);

 private:
  template <int Dim>
  struct SkinArrays {
    explicit SkinArrays(base::MemoryMeter& memory) : candidates(memory), insertion(memory) {}

    skin::SkinSearch<Dim> candidates;
    elements::GatheredElements<Dim> insertion;  ///< new elements and all, while they are searched
  };

  template <int Dim>
  [[nodiscard]] Source find_source(const SkinCall<Dim>& call);
  template <int Dim>
  [[nodiscard]] bool carry_over(const SkinCall<Dim>& call, const skin::NamedElements& named);
  template <int Dim>
  [[nodiscard]] bool find_candidates(const SkinCall<Dim>& call, const skin::NamedElements& named);
  template <int Dim>
  void search_insertion(const SkinCall<Dim>& call,
                        const typename skin::SkinSearch<Dim>::Insertion& insertion);
  [[nodiscard]] skin::NamedElements name_elements(std::size_t count);
  void note(Source source, const Statistics& statistics);
  void note_kept(Source source, std::size_t elements, base::DetectionContext& context,
                 Statistics& statistics);
  template <int Dim>
  void note_candidates(const SearchTask& task, Source source, Statistics& statistics);

  skin::SkinChoice choice_;
  SkinStatistics statistics_;
  elements::ElementIds ids_;
  elements::ElementIds next_ids_;
  std::uint64_t ids_version_ = 0;
  Algorithm candidates_from_ = Algorithm::automatic;
  base::ByDimension<SkinArrays> arrays_;
};

}  // namespace abut::detect
