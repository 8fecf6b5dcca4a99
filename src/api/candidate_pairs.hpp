#pragma once

#include "api/displacement.hpp"
#include "api/found_pairs.hpp"
#include "api/order_pairs.hpp"
#include "api/snapshot.hpp"
#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::api {

/// Candidate pairs in canonical order, kept from call to call. In a periodic domain with the image
/// shift between the elements as they are placed (Displacement), by number in a list of the few
/// different ones.
template <int Dim>
class CandidatePairs {
 public:
  explicit CandidatePairs(base::MemoryMeter& memory);

  /// Where a search puts them; those there were are dropped.
  [[nodiscard]] base::PairSink& start_anew(bool periodic);

  /// Puts what the search found in order. False if there are too many different image shifts.
  [[nodiscard]] bool finish(const Snapshot<Dim>& now, const Displacement<Dim>& placing);

  [[nodiscard]] PairCount size() const noexcept { return size_; }

  /// Delivers those that are contact pairs now, in canonical order, whatever the number of workers.
  void deliver_contacts(const Snapshot<Dim>& now, const Displacement<Dim>& placing,
                        base::PairSink& sink, base::DetectionContext& context);

 private:
  using ShiftNumber = std::uint16_t;

  [[nodiscard]] bool number_shifts(const Displacement<Dim>& placing, std::size_t workers);

  FoundPairs found_;
  PairOrder order_;
  bool periodic_ = false;
  PairCount size_ = 0;
  base::Array<ContactPair> pairs_;
  base::Array<ImageShift> shifts_;  ///< as found; only while they are numbered
  base::Array<ShiftNumber> shift_of_;
  std::vector<ImageShift> shift_list_;
  std::vector<std::array<double, Dim>> images_;
};

}  // namespace abut::api
