#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "detect/validate_options.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/lattice_of.hpp"
#include "elements/require_dimensions.hpp"
#include "exact/box.hpp"
#include "exact/periodic_box.hpp"
#include "exact/periodic_gap.hpp"
#include "exact/sphere_gap.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/two_sets.hpp>

#include <string>

namespace abut {
namespace {

/// The two elements of a pair, each in its set: for one set, the same twice.
struct Sets {
  const ElementView& first;
  const ElementView& second;

  void require(std::size_t number, const ElementView& elements) const {
    if (number < elements.size()) return;
    throw Error(ErrorCode::wrong_usage,
                "element " + std::to_string(number) + " of a pair; there are " +
                    std::to_string(elements.size()) + " elements, numbered from 0");
  }

  void require(ContactPair pair) const {
    require(pair.first, first);
    require(pair.second, second);
  }
};

template <int Dim>
double gap_of(const Sets& sets, ContactPair pair) {
  if (sets.first.shape() == Shape::box) {
    return exact::gap(elements::box_at<Dim>(sets.first, pair.first),
                      elements::box_at<Dim>(sets.second, pair.second));
  }
  return exact::gap(elements::sphere_at<Dim>(sets.first, pair.first),
                    elements::sphere_at<Dim>(sets.second, pair.second));
}

template <int Dim>
double gap_of(const Sets& sets, const Domain& domain, ContactPair pair, const ImageShift& shift) {
  if (sets.first.shape() == Shape::box) {
    return exact::gap<Dim>(elements::box_at<Dim>(sets.first, pair.first),
                           elements::box_at<Dim>(sets.second, pair.second), shift,
                           elements::lattice_of(domain));
  }
  return exact::gap<Dim>(elements::sphere_at<Dim>(sets.first, pair.first),
                         elements::sphere_at<Dim>(sets.second, pair.second), shift,
                         elements::lattice_of(domain));
}

double checked_gap(const Sets& sets, ContactPair pair) {
  base::reporting_lack_of_memory([&] {
    detect::require_alike(sets.first, sets.second);
    sets.require(pair);
  });
  const base::FloatEnvironment environment;
  return sets.first.dimensions() == 2 ? gap_of<2>(sets, pair) : gap_of<3>(sets, pair);
}

double checked_gap(const Sets& sets, const Domain& domain, ContactPair pair,
                   const ImageShift& shift) {
  base::reporting_lack_of_memory([&] {
    detect::require_alike(sets.first, sets.second);
    sets.require(pair);
    detect::require_dimensions(sets.first, domain);
    elements::require_there(domain, shift);
  });
  const base::FloatEnvironment environment;
  return sets.first.dimensions() == 2 ? gap_of<2>(sets, domain, pair, shift)
                                      : gap_of<3>(sets, domain, pair, shift);
}

}  // namespace

double gap(const ElementView& elements, ContactPair pair) {
  return checked_gap({elements, elements}, pair);
}

double gap(const ElementView& elements, const Domain& domain, ContactPair pair,
           const ImageShift& shift) {
  return checked_gap({elements, elements}, domain, pair, shift);
}

double gap(const ElementView& first, const ElementView& second, ContactPair pair) {
  return checked_gap({first, second}, pair);
}

double gap(const ElementView& first, const ElementView& second, const Domain& domain,
           ContactPair pair, const ImageShift& shift) {
  return checked_gap({first, second}, domain, pair, shift);
}

}  // namespace abut
