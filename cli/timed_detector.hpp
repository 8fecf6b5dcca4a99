#pragma once

#include "device_search.hpp"
#include "options/device_option.hpp"

#include <abut/detector.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::cli {

/// The forms of results that a detection is asked for.
enum class Form { canonical, as_found, count, half_list, full_list };
[[nodiscard]] std::string_view name_of(Form form);

/// A detector that is asked for the same again and again, by the clock. One on a device has its
/// elements there, and is asked for pairs in canonical order or for their number.
class TimedDetector {
 public:
  TimedDetector(const ElementView& elements, const Domain& domain, const Options& options,
                Form form, DeviceChoice device);

  /// One detection; its wall-clock time in seconds.
  [[nodiscard]] double call();

  /// Sets the progress hook for the calls that follow.
  void set_progress(ProgressHook hook);

  /// Statistics of the last call.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

  /// Digest of the pairs of the last call in canonical order, without image shifts; empty if they
  /// were only counted.
  [[nodiscard]] std::string digest() const;

 private:
  void call_on_device();
  void call_on_processor();
  [[nodiscard]] std::vector<ContactPair> canonical_pairs() const;

  ElementView elements_;
  Domain domain_;
  Form form_;
  Detector detector_;
  std::optional<DeviceSearch> on_device_;  ///< takes the place of the detector
  Statistics statistics_;
  const PairList* pairs_ = nullptr;
  const device::PairList* pairs_on_device_ = nullptr;
  const NeighborList* neighbors_ = nullptr;
};

}  // namespace abut::cli
