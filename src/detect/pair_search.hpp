#pragma once

#include "base/by_dimension.hpp"
#include "base/detection_context.hpp"
#include "base/memory_meter.hpp"
#include "base/pair_sink.hpp"
#include "detect/detection_request.hpp"
#include "detect/element_search.hpp"
#include "detect/skin_detection.hpp"
#include "detect/two_set_search.hpp"
#include "elements/gathered_elements.hpp"
#include "lists/rule_sink.hpp"

#include <abut/statistics.hpp>

namespace abut::detect {

/// Checks options, elements, domain and rule. Throws as find_contact_pairs does.
void validate_request(const DetectionRequest& request);

/// The elements of a request, and the searches that they may need.
template <int Dim>
struct SearchArrays {
  explicit SearchArrays(base::MemoryMeter& memory)
      : elements(memory), search(memory), two_set_search(memory) {}

  elements::GatheredElements<Dim> elements;
  ElementSearch<Dim> search;
  TwoSetSearch<Dim> two_set_search;
};

/// Finds the contact pairs of a request: the inside of a detection, for callers that have checked
/// the request, stand in a guard of their own and bring memory meter and context. It keeps its
/// memory from call to call, and is too large for the stack (75 KiB).
class PairSearch {
 public:
  explicit PairSearch(base::MemoryMeter& memory)
      : arrays_{SearchArrays<2>(memory), SearchArrays<3>(memory)}, skin_(memory) {}
  PairSearch(const PairSearch&) = delete;
  PairSearch& operator=(const PairSearch&) = delete;
  ~PairSearch() = default;

  /// Delivers every contact pair once to `sink`. The counters stay in the context.
  Statistics find(const DetectionRequest& request, base::PairSink& sink,
                  base::DetectionContext& context);

  /// Gives back the arrays of the last search, and of the elements too where these are not to be
  /// measured.
  void give_back_memory(const DetectionRequest& request);

  /// The elements of the last request, unless their memory was given back.
  template <int Dim>
  [[nodiscard]] const SearchArrays<Dim>& arrays() const noexcept {
    return arrays_.in<Dim>();
  }

  /// The part that keeps candidate pairs, for its settings and its statistics.
  [[nodiscard]] SkinDetection& skin() noexcept { return skin_; }
  [[nodiscard]] const SkinDetection& skin() const noexcept { return skin_; }

 private:
  template <int Dim>
  Statistics find_in(const DetectionRequest& request, base::PairSink& sink,
                     base::DetectionContext& context);
  [[nodiscard]] bool can_do_without_gathering(const DetectionRequest& request) const noexcept;
  [[nodiscard]] bool may_search_in_place(const DetectionRequest& request) const noexcept;
  template <int Dim>
  void give_back_memory_in(const DetectionRequest& request);
  template <int Dim>
  void search(const DetectionRequest& request, const SearchTask& task, base::PairSink& sink,
              base::DetectionContext& context, Statistics& statistics);

  base::ByDimension<SearchArrays> arrays_;
  SkinDetection skin_;
  lists::RuleSink ruling_;
};

}  // namespace abut::detect
