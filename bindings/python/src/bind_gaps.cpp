#include "array_out.hpp"
#include "bind.hpp"
#include "elements.hpp"
#include "pair_arrays.hpp"

#include <abut/detect.hpp>
#include <abut/domain.hpp>
#include <abut/two_sets.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace abut::python {

namespace {

/// Computes the gap of each pair by the function for one pair.
nb::ndarray<nb::numpy, double> gaps(const Elements& elements, const Elements* others,
                                    const Domain& domain, nb::handle pair_array,
                                    nb::handle shift_array) {
  const PairArrays arrays(pair_array, shift_array);
  const std::size_t partners = others != nullptr ? others->view().size() : elements.view().size();
  arrays.require_indices_below(elements.view().size(), partners);
  std::vector<double> result(arrays.pairs().size());
  {
    const nb::gil_scoped_release unlocked;
    for (std::size_t k = 0; k < result.size(); ++k) {
      const ContactPair pair = arrays.pairs()[k];
      const ImageShift shift = arrays.shift(k);
      result[k] = others != nullptr ? gap(elements.view(), others->view(), domain, pair, shift)
                                    : gap(elements.view(), domain, pair, shift);
    }
  }
  return given_away(std::move(result));
}

}  // namespace

void bind_gaps(nb::module_& module) {
  module.def("gaps", &gaps, nb::arg("elements"), nb::arg("others").none(), nb::arg("domain"),
             nb::arg("pairs"), nb::arg("shifts").none());
}

}  // namespace abut::python
