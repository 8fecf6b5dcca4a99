#pragma once

#include <abut/device.hpp>
#include <abut/device_elements.hpp>
#include <abut/element_view.hpp>
#include <abut/error.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/options.hpp>
#include <abut/pair_list.hpp>
#include <abut/statistics.hpp>

#include <optional>
#include <string>

namespace abut::cli {

/// Throws Error{unavailable} unless the device is there: before a large file is read in vain.
void require_device(int device);

/// "gpu:0, NVIDIA H200"; the number alone where its name is not known.
[[nodiscard]] std::string device_text(int device);

/// The error of the library of devices in words of the command line: its advice is for programs.
[[nodiscard]] Error in_words_of_tool(const Error& error);

/// Returns what `work` gives, its errors in words of the command line.
template <class Work>
auto in_words_of_tool(const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw in_words_of_tool(error);
  }
}

/// Copies of the elements, of one set or of two, and of who may pair on a device, and a detector
/// there, which is asked again and again.
class DeviceSearch {
 public:
  /// `others` is the second set; null for one.
  DeviceSearch(int device, const ElementView& elements, const ElementView* others,
               const Options& options);

  void set_progress(ProgressHook hook);

  /// Finds the pairs, which stay on the device until the next call, and waits for them.
  const device::PairList& find(const Domain& domain);
  [[nodiscard]] Statistics count(const Domain& domain);
  /// A copy of the neighbors that it finds; those of two sets have no kind.
  [[nodiscard]] NeighborList neighbors(const Domain& domain, NeighborListKind kind);

 private:
  device::ElementCopy copy_;
  std::optional<device::ElementCopy> partners_;  ///< of the second set
  device::RuleCopy rule_;
  device::Detector detector_;
};

}  // namespace abut::cli
