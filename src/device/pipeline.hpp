#pragma once

#include "base/progress_reporter.hpp"
#include "device/checked_elements.hpp"
#include "device/detection.hpp"
#include "device/device_request.hpp"
#include "device/executor.hpp"
#include "device/finish_list.hpp"
#include "device/found_list.hpp"
#include "device/overview.hpp"

namespace abut::device {

/// One detection of spheres in an open domain, stage by stage, on any executor:
/// check, frame, place and sort, count, write, decide, order. The host waits where it must know
/// numbers: of the elements, of pairs, of pairs of larger elements with those of lower levels, if
/// there are several, and of contacts, with the longest row.
template <int Dim, class T, class E>
class Pipeline {
 public:
  Pipeline(E& executor, const SphereColumns<Dim, T>& elements, const DeviceRequest& request,
           base::ProgressReporter& progress)
      : executor_(executor), elements_(elements), request_(request), progress_(progress) {}

  /// All contact pairs, in canonical order, in the form that is asked for.
  [[nodiscard]] FoundList<E> list() {
    FoundList<E> found;
    detect([&](auto& detection) { detection.list(found); });
    finish_list(executor_, elements_, elements_.count, request_, progress_, found);
    return found;
  }

  /// Their number.
  [[nodiscard]] FoundList<E> count() {
    FoundList<E> found;
    detect([&](auto& detection) { detection.count(found); });
    return found;
  }

 private:
  template <class Use>
  void detect(Use&& use) {
    progress_.begin("gather", elements_.count);
    if (elements_.count == 0) return;
    const Overview<Dim> overview = overview_of_elements();
    require_valid(executor_, elements_, overview.all);
    progress_.begin("search", elements_.count);
    Detection<SphereColumns<Dim, T>, E> detection(
        executor_, elements_, overview, request_,
        {request_.margin, 0.0, request_.items_at_a_time, request_.narrow_places});
    use(detection);
  }

  /// Waits: a bad element is told before anything is done with it, and levels and cells follow it.
  [[nodiscard]] Overview<Dim> overview_of_elements() {
    const Buffer<Overview<Dim>, E> on_device(executor_, 1);
    write_overview(executor_, elements_, on_device.data());
    Overview<Dim> overview;
    executor_.copy_to_host(&overview, on_device.data(), 1);
    return overview;
  }

  E& executor_;
  SphereColumns<Dim, T> elements_;
  DeviceRequest request_;
  base::ProgressReporter& progress_;
};

}  // namespace abut::device
