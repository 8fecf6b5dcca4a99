#include "timed_detector.hpp"

#include "interrupt.hpp"
#include "io/write/digest.hpp"
#include "phase_seconds.hpp"

#include <algorithm>
#include <utility>

namespace abut::cli {
namespace {

Options in_order_of(Form form, Options options) {
  options.order = form == Form::as_found ? Order::as_found : Order::canonical;
  return options;
}

}  // namespace

std::string_view name_of(Form form) {
  switch (form) {
    case Form::as_found:
      return "as_found";
    case Form::count:
      return "count";
    case Form::half_list:
      return "half list";
    case Form::full_list:
      return "full list";
    case Form::canonical:
      break;
  }
  return "canonical";
}

TimedDetector::TimedDetector(const ElementView& elements, const Domain& domain,
                             const Options& options, Form form, DeviceChoice device)
    : elements_(elements), domain_(domain), form_(form), detector_(in_order_of(form, options)) {
  if (device) on_device_.emplace(*device, elements, nullptr, options);
}

void TimedDetector::set_progress(ProgressHook hook) {
  if (on_device_) {
    on_device_->set_progress(std::move(hook));
    return;
  }
  Options options = detector_.options();
  options.progress = std::move(hook);
  detector_.set_options(std::move(options));
}

double TimedDetector::call() {
  PhaseStopwatch stopwatch;
  on_device_ ? call_on_device() : call_on_processor();
  const double seconds = stopwatch.lap();
  if (neighbors_ != nullptr) statistics_ = neighbors_->statistics();
  if (pairs_ != nullptr) statistics_ = pairs_->statistics();
  if (pairs_on_device_ != nullptr) statistics_ = pairs_on_device_->statistics();
  return seconds;
}

void TimedDetector::call_on_device() {
  if (form_ == Form::count) {
    statistics_ = on_device_->count(domain_);
  } else {
    pairs_on_device_ = &on_device_->find(domain_);
  }
}

void TimedDetector::call_on_processor() {
  if (form_ == Form::count) {
    statistics_ = detector_.count_contact_pairs(elements_, domain_);
  } else if (form_ == Form::half_list || form_ == Form::full_list) {
    const auto kind = form_ == Form::half_list ? NeighborListKind::half : NeighborListKind::full;
    neighbors_ = &detector_.build_neighbor_list(elements_, domain_, kind);
  } else {
    pairs_ = &detector_.find_contact_pairs(elements_, domain_);
  }
}

std::string TimedDetector::digest() const {
  const InterruptsEndAtOnce at_once;
  return form_ == Form::count ? "" : io::digest(canonical_pairs());
}

std::vector<ContactPair> TimedDetector::canonical_pairs() const {
  std::vector<ContactPair> pairs;
  if (pairs_on_device_ != nullptr) {
    const PairList copy = pairs_on_device_->to_host();
    pairs.assign(copy.begin(), copy.end());
  }
  if (pairs_ != nullptr) {
    pairs.assign(pairs_->begin(), pairs_->end());
    if (form_ == Form::as_found) std::sort(pairs.begin(), pairs.end());
  }
  if (neighbors_ != nullptr) {
    // A pair of an element with an image of itself stands twice in a row of a full list.
    const std::size_t in_own_row = form_ == Form::full_list ? 2 : 1;
    for (std::size_t first = 0; first < neighbors_->size(); ++first) {
      std::size_t own = 0;
      for (const ElementIndex second : (*neighbors_)[first]) {
        if (second < first || (second == first && ++own % in_own_row != 0)) continue;
        pairs.push_back({static_cast<ElementIndex>(first), second});
      }
    }
  }
  return pairs;
}

}  // namespace abut::cli
