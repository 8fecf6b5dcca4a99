#include "bind.hpp"
#include "call_options.hpp"
#include "progress_calls.hpp"

#include <abut/error.hpp>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace abut::python {

namespace {

/// Finds the value of a name, or says which names there are.
template <class Value, std::size_t Count>
Value named(std::string_view what, std::string_view name,
            const std::array<std::pair<std::string_view, Value>, Count>& names) {
  std::string known;
  for (const auto& [text, value] : names) {
    if (text == name) return value;
    known += (known.empty() ? "" : ", ") + std::string(text);
  }
  throw Error(ErrorCode::wrong_usage,
              std::string(what) + " '" + std::string(name) + "' is not there; there are " + known);
}

Order order_named(std::string_view name) {
  return named("order", name,
               std::array<std::pair<std::string_view, Order>, 2>{
                   {{"canonical", Order::canonical}, {"as_found", Order::as_found}}});
}

Quantity quantity_named(std::string_view name) {
  return named(
      "quantity", name,
      std::array<std::pair<std::string_view, Quantity>, 5>{{{"gap", Quantity::gap},
                                                            {"normal", Quantity::normal},
                                                            {"point", Quantity::point},
                                                            {"distance", Quantity::distance},
                                                            {"vector", Quantity::vector}}});
}

Quantities quantities_named(const nb::tuple& names) {
  Quantities result;
  for (const nb::handle name : names) {
    result = result | quantity_named(nb::cast<std::string_view>(name));
  }
  return result;
}

void init(CallOptions* place, double margin, std::string_view algorithm, std::string_view order,
          bool shifts, const nb::tuple& quantities, nb::object rule,
          std::optional<std::uint64_t> max_pairs, std::optional<std::uint64_t> max_bytes,
          std::optional<int> threads, std::string_view simd, nb::object progress) {
  Options options;
  options.margin = margin;
  options.algorithm = algorithm_named(algorithm);
  options.order = order_named(order);
  options.simd = simd_named(simd);
  options.shifts = shifts ? Shifts::stored : Shifts::none;
  options.quantities = quantities_named(quantities);
  if (!rule.is_none()) options.rule = nb::cast<const HeldRule&>(rule).rule;
  if (max_pairs) options.max_pairs = *max_pairs;
  if (max_bytes) options.max_bytes = *max_bytes;
  if (threads) options.threads = *threads;
  new (place) CallOptions{std::move(options), std::move(rule), std::move(progress)};
}

}  // namespace

Options CallOptions::of_call() const {
  Options result = options;
  result.progress = progress_hook(progress);
  return result;
}

void bind_options(nb::module_& module) {
  nb::class_<CallOptions>(module, "CallOptions")
      .def("__init__", &init, nb::arg("margin"), nb::arg("algorithm"), nb::arg("order"),
           nb::arg("shifts"), nb::arg("quantities"), nb::arg("rule").none(),
           nb::arg("max_pairs").none(), nb::arg("max_bytes").none(), nb::arg("threads").none(),
           nb::arg("simd"), nb::arg("progress").none());
}

}  // namespace abut::python
