#include "array_out.hpp"
#include "bind.hpp"
#include "call_options.hpp"
#include "connectivity.hpp"
#include "elements.hpp"
#include "held_results.hpp"
#include "pair_arrays.hpp"

#include <abut/simplex_contacts.hpp>

#include <nanobind/ndarray.h>
#include <nanobind/stl/shared_ptr.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace abut::python {

namespace {

/// Simplices in arrays of Python, which it keeps alive and does not copy.
class HeldSimplices {
 public:
  HeldSimplices(nb::object vertices, nb::handle cells)
      : vertices_(std::move(vertices)),
        cells_(cells),
        view_(nb::cast<const Elements&>(vertices_).view(), cells_.view()) {}
  HeldSimplices(HeldSimplices&&) = default;
  HeldSimplices(const HeldSimplices&) = delete;

  [[nodiscard]] const SimplexView& view() const noexcept { return view_; }

 private:
  nb::object vertices_;  ///< Elements, which hold the arrays of the vertices
  HeldConnectivity cells_;
  SimplexView view_;
};

std::shared_ptr<PairResults> find(const HeldSimplices& simplices, const HeldSimplices* others,
                                  const Domain& domain, const CallOptions& options,
                                  bool excludes_shared) {
  const Options of_call = options.of_call();
  const SharedVertices shared =
      excludes_shared ? SharedVertices::excluded : SharedVertices::touching;
  PairList list;
  {
    const nb::gil_scoped_release unlocked;
    list = others != nullptr
               ? find_simplex_contacts(simplices.view(), others->view(), domain, of_call, shared)
               : find_simplex_contacts(simplices.view(), domain, of_call, shared);
  }
  return std::make_shared<PairResults>(std::move(list));
}

/// Decides pairs one by one: 1 for each that touches, else 0. Other threads of Python run, and
/// Ctrl-C is noticed between blocks of pairs.
nb::ndarray<nb::numpy, std::uint8_t> decided(const HeldSimplices& first,
                                             const HeldSimplices& second, const Domain& domain,
                                             nb::handle pairs, nb::handle shifts) {
  constexpr std::size_t block = 4096;
  const PairArrays arrays(pairs, shifts);
  const std::span<const ContactPair> given = arrays.pairs();
  std::vector<std::uint8_t> answers(given.size());
  for (std::size_t begin = 0; begin < given.size(); begin += block) {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    const nb::gil_scoped_release unlocked;
    for (std::size_t k = begin; k < std::min(begin + block, given.size()); ++k) {
      answers[k] = touching(first.view(), second.view(), domain, given[k], arrays.shift(k)) ? 1 : 0;
    }
  }
  return given_away(std::move(answers));
}

}  // namespace

void bind_simplices(nb::module_& module) {
  nb::class_<HeldSimplices>(module, "Simplices",
                            "Simplices in arrays of the caller, which are not copied.")
      .def(nb::init<nb::object, nb::handle>(), nb::arg("vertices"), nb::arg("cells"))
      .def("__len__", [](const HeldSimplices& held) { return held.view().size(); })
      .def_prop_ro("dimensions",
                   [](const HeldSimplices& held) { return held.view().dimensions(); });
  module.def("find_simplex_contacts", &find, nb::arg("simplices"), nb::arg("others").none(),
             nb::arg("domain"), nb::arg("options"), nb::arg("excludes_shared"));
  module.def("touching", &decided, nb::arg("first"), nb::arg("second"), nb::arg("domain"),
             nb::arg("pairs"), nb::arg("shifts").none());
}

}  // namespace abut::python
