#pragma once

#include <abut/detector.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace abut::cli {

/// The forms of results that a detection is asked for.
enum class Form { canonical, as_found, count, half_list, full_list };
[[nodiscard]] std::string_view name_of(Form form);

/// A detector that is asked for the same again and again, by the clock.
class TimedDetector {
 public:
  TimedDetector(const ElementView& elements, const Domain& domain, const Options& options,
                Form form);

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
  [[nodiscard]] std::vector<ContactPair> canonical_pairs() const;

  ElementView elements_;
  Domain domain_;
  Form form_;
  Detector detector_;
  Statistics statistics_;
  const PairList* pairs_ = nullptr;
  const NeighborList* neighbors_ = nullptr;
};

}  // namespace abut::cli
