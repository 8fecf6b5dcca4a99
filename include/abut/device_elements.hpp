#pragma once

#include <abut/device.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/pair_rule.hpp>

#include <memory>

namespace abut::device {

/// A copy of elements in the memory of a device, for elements that lie on the host: a column of
/// its own for each of theirs, in their precision.
class ABUT_API ElementCopy {
 public:
  /// Copies the elements and waits until they are there. Throws Error{unavailable} where there is
  /// no such device, and Error{limit_exceeded} where it has too little memory.
  explicit ElementCopy(const ElementView& on_host, Device device = on(0));
  /// Releases the memory of the device.
  ~ElementCopy();

  /// Takes over another copy.
  ElementCopy(ElementCopy&&) noexcept;
  /// Takes over another copy.
  ElementCopy& operator=(ElementCopy&&) noexcept;
  ElementCopy(const ElementCopy&) = delete;
  ElementCopy& operator=(const ElementCopy&) = delete;

  /// The elements on the device, what a Detector there takes.
  [[nodiscard]] const ElementView& elements() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A copy of the arrays of a rule in the memory of a device, for arrays that lie on the host. Table
/// and exclusions stay where they are: a detection copies them.
class ABUT_API RuleCopy {
 public:
  /// Copies the arrays and waits until they are there. Throws what ElementCopy throws.
  explicit RuleCopy(const PairRule& on_host, Device device = on(0));
  /// Releases the memory of the device.
  ~RuleCopy();

  /// Takes over another copy.
  RuleCopy(RuleCopy&&) noexcept;
  /// Takes over another copy.
  RuleCopy& operator=(RuleCopy&&) noexcept;
  RuleCopy(const RuleCopy&) = delete;
  RuleCopy& operator=(const RuleCopy&) = delete;

  /// The rule with its arrays on the device, what the options of a Detector there take.
  [[nodiscard]] const PairRule& rule() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abut::device
