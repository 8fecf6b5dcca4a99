#pragma once

#include "number_buffer.hpp"

#include <abut/exclusion_list.hpp>
#include <abut/group_table.hpp>
#include <abut/options.hpp>

#include <nanobind/nanobind.h>

#include <vector>

namespace abut::python {

namespace nb = nanobind;

/// A rule with the arrays and tables of Python that it looks at.
struct HeldRule {
  HeldRule() = default;
  HeldRule(HeldRule&&) = default;
  HeldRule(const HeldRule&) = delete;

  PairRule rule;
  std::vector<NumberBuffer> buffers;
  std::vector<nb::object> tables;
};

/// Options with the objects of Python that they look at.
struct CallOptions {
  Options options;
  nb::object rule;      ///< a HeldRule or None
  nb::object progress;  ///< a function or None

  /// The options of one call, with a hook of its own.
  [[nodiscard]] Options of_call() const;
};

}  // namespace abut::python
