#pragma once

#include <abut/statistics.hpp>

#include <nanobind/nanobind.h>

namespace abut::python {

namespace nb = nanobind;

/// The fields of the statistics by name, for the class Statistics of the package.
[[nodiscard]] nb::dict fields_of(const Statistics& statistics);

}  // namespace abut::python
