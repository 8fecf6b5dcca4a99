#include "simplices/simplex_search.hpp"

#include "base/callers_exception.hpp"
#include "base/detection_context.hpp"
#include "base/lack_of_memory.hpp"
#include "base/memory_meter.hpp"
#include "base/stopwatch.hpp"
#include "base/workers.hpp"
#include "detect/detection_request.hpp"
#include "detect/pair_search.hpp"
#include "detect/validate_options.hpp"
#include "lists/found_pairs.hpp"
#include "lists/order_pairs.hpp"
#include "lists/result_buffer.hpp"
#include "simplices/gathered_simplices.hpp"
#include "simplices/touch_sink.hpp"
#include "walls/box_view.hpp"

#include <abut/error.hpp>
#include <abut/image_shift.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace abut::simplices {
namespace {

/// One detection, with what all its steps share.
template <int Dim>
class SimplexSearch {
 public:
  explicit SimplexSearch(const SimplexRequest& request)
      : request_(request),
        memory_(detect::memory_bound(request.options)),
        context_(memory_, request.options.progress) {}

  [[nodiscard]] PairList run() {
    return base::letting_through([&] {
      return base::reporting_lack_of_memory(memory_, [&] {
        require_supported(request_);
        // Before memory is taken: what does not depend on the elements.
        detect::validate(request_.options, no_elements(), request_.domain);
        gather_sets();
        return find();
      });
    });
  }

 private:
  [[nodiscard]] static ElementView no_elements() {
    return ElementView(std::array<Column<double>, std::size_t{Dim}>{}, 0.0);
  }

  [[nodiscard]] bool is_periodic() const noexcept { return request_.domain.is_periodic(); }

  void gather_sets() {
    const SimplexView* const others = request_.others;
    const std::size_t size = request_.first.size() + (others == nullptr ? 0 : others->size());
    const std::size_t workers = base::worker_count(request_.options.threads, size);
    base::Stopwatch stopwatch;
    context_.progress.begin("gather", size);
    first_.emplace(gather<Dim>(request_.first, workers, context_));
    if (others != nullptr) {
      try {
        second_.emplace(gather<Dim>(*others, workers, context_));
      } catch (const Error& error) {
        if (error.code() != ErrorCode::invalid_input) throw;
        throw Error(error.code(), std::string(error.what()) + " (in the second set)");
      }
    }
    gather_seconds_ = stopwatch.lap();
  }

  [[nodiscard]] PairList find() {
    const ElementView boxes = walls::view_of<Dim>(first_->boxes);
    std::optional<ElementView> others;
    if (second_) others = walls::view_of<Dim>(second_->boxes);
    const detect::DetectionRequest search{boxes, request_.domain, request_.options,
                                          others ? &*others : nullptr};
    detect::validate_request(search);
    lists::FoundPairs found(memory_);
    // An image is decided where its shift is known, wanted or not.
    found.start_anew({.limit = request_.options.max_pairs,
                      .shifts = is_periodic() ? Shifts::stored : Shifts::none,
                      .order = request_.options.order});
    TouchSink<Dim> touching(*first_, second_ ? *second_ : *first_, request_, context_.progress,
                            found);
    Statistics statistics =
        std::make_unique<detect::PairSearch>(memory_)->find(search, touching, context_);
    statistics.gather_seconds += gather_seconds_;
    statistics.candidate_tests = touching.tests();
    statistics.exact_decisions = touching.exact_decisions();
    return listed(found, statistics);
  }

  [[nodiscard]] PairList listed(lists::FoundPairs& found, Statistics& statistics) {
    base::Stopwatch stopwatch;
    context_.progress.begin("order", found.size());
    PairArray pairs;
    ShiftArray shifts;
    const bool are_wanted = request_.options.shifts == Shifts::stored;
    const lists::ResultBuffer pair_buffer(pairs, found.size(), memory_);
    const lists::ResultBuffer shift_buffer(shifts, are_wanted || is_periodic() ? found.size() : 0,
                                           memory_);
    if (!is_periodic()) std::fill(shifts.begin(), shifts.end(), ImageShift{});
    lists::OutputBuffer target{pairs, {}};
    if (is_periodic()) target.shifts = shifts;
    const auto workers = static_cast<std::size_t>(statistics.threads);
    lists::PairOrder order(memory_);
    if (found.must_be_sorted()) {
      order.sort(found.pieces(), first_->boxes.size(), target, workers, context_.work);
    } else {
      order.join(found.pieces(), target, workers, context_.work);
    }
    if (!are_wanted) shifts = ShiftArray{};
    statistics.order_seconds = stopwatch.lap();
    statistics.contact_pairs = found.size();
    statistics.list_insertions = context_.list_insertions;
    statistics.peak_bytes = memory_.peak();
    statistics.working_bytes = memory_.working_peak();
    return PairList(std::move(pairs), std::move(shifts), std::move(statistics));
  }

  const SimplexRequest& request_;
  base::MemoryMeter memory_;
  base::DetectionContext context_;
  double gather_seconds_ = 0.0;
  std::optional<GatheredSimplices<Dim>> first_;
  std::optional<GatheredSimplices<Dim>> second_;
};

}  // namespace

template <int Dim>
PairList find(const SimplexRequest& request) {
  return SimplexSearch<Dim>(request).run();
}

template PairList find<2>(const SimplexRequest&);
template PairList find<3>(const SimplexRequest&);

}  // namespace abut::simplices
