#include "bind.hpp"
#include "call_options.hpp"
#include "elements.hpp"
#include "geometry_out.hpp"
#include "pair_arrays.hpp"

#include <abut/measure.hpp>

#include <cstddef>
#include <utility>

namespace abut::python {

namespace {

PairSpans spans_of(const PairArrays& arrays) {
  return {arrays.pairs(), arrays.shifts()};
}

/// Measures pairs in all threads while other threads of Python run.
nb::dict measured(const Elements& elements, const Elements* others, const Domain& domain,
                  nb::handle pairs, nb::handle shifts, const CallOptions& options) {
  const PairArrays arrays(pairs, shifts);
  const Options of_call = options.of_call();
  const Quantities wanted = of_call.quantities;
  PairGeometry geometry;
  {
    const nb::gil_scoped_release unlocked;
    geometry =
        others != nullptr
            ? measure(elements.view(), others->view(), spans_of(arrays), wanted, domain, of_call)
            : measure(elements.view(), spans_of(arrays), wanted, domain, of_call);
  }
  return arrays_of(std::move(geometry), wanted);
}

/// A measurer with the options whose progress function it may call.
class HeldMeasurer {
 public:
  HeldMeasurer(const Elements& elements, const Elements* others, const Domain& domain,
               nb::object options)
      : options_(std::move(options)),
        measurer_(made(elements, others, domain, nb::cast<const CallOptions&>(options_))) {}

  [[nodiscard]] nb::dict measure(nb::handle pairs, nb::handle shifts,
                                 const CallOptions& options) const {
    const PairArrays arrays(pairs, shifts);
    const Quantities wanted = options.options.quantities;
    PairGeometry geometry = room_for(arrays.pairs().size(), wanted);
    {
      const nb::gil_scoped_release unlocked;
      measurer_.measure(spans_of(arrays), geometry.spans());
    }
    return arrays_of(std::move(geometry), wanted);
  }

 private:
  static PairMeasurer made(const Elements& elements, const Elements* others, const Domain& domain,
                           const CallOptions& options) {
    const Options of_call = options.of_call();
    const nb::gil_scoped_release unlocked;
    return others != nullptr ? PairMeasurer(elements.view(), others->view(), domain, of_call)
                             : PairMeasurer(elements.view(), domain, of_call);
  }

  static PairGeometry room_for(std::size_t pairs, Quantities wanted) {
    PairGeometry geometry;
    if (wanted.has(Quantity::gap)) geometry.gaps.resize(pairs);
    if (wanted.has(Quantity::normal)) geometry.normals.resize(pairs);
    if (wanted.has(Quantity::point)) geometry.points.resize(pairs);
    if (wanted.has(Quantity::distance)) geometry.distances.resize(pairs);
    if (wanted.has(Quantity::vector)) geometry.vectors.resize(pairs);
    return geometry;
  }

  nb::object options_;
  PairMeasurer measurer_;
};

}  // namespace

nb::dict arrays_of(PairGeometry geometry, Quantities wanted) {
  nb::dict arrays;
  if (wanted.has(Quantity::gap)) arrays["gap"] = given_away(std::move(geometry.gaps));
  if (wanted.has(Quantity::normal))
    arrays["normal"] = table_given_away(std::move(geometry.normals));
  if (wanted.has(Quantity::point)) arrays["point"] = table_given_away(std::move(geometry.points));
  if (wanted.has(Quantity::distance)) {
    arrays["distance"] = given_away(std::move(geometry.distances));
  }
  if (wanted.has(Quantity::vector))
    arrays["vector"] = table_given_away(std::move(geometry.vectors));
  return arrays;
}

void bind_measure(nb::module_& module) {
  module.def("measure", &measured, nb::arg("elements"), nb::arg("others").none(), nb::arg("domain"),
             nb::arg("pairs"), nb::arg("shifts").none(), nb::arg("options"));
  nb::class_<HeldMeasurer>(module, "PairMeasurer")
      .def(nb::init<const Elements&, const Elements*, const Domain&, nb::object>(),
           nb::arg("elements"), nb::arg("others").none(), nb::arg("domain"), nb::arg("options"))
      .def("measure", &HeldMeasurer::measure, nb::arg("pairs"), nb::arg("shifts").none(),
           nb::arg("options"));
}

}  // namespace abut::python
