#include "fuzz/element_maker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace abut::fuzz {
namespace {

std::size_t axes_of(const ElementArrays& elements) {
  return static_cast<std::size_t>(elements.dimensions);
}

double half_side(const ElementArrays& elements, std::size_t k, std::size_t axis) {
  if (elements.shape == Shape::sphere) return elements.radius[k];
  return 0.5 * elements.upper[axis][k] - 0.5 * elements.lower[axis][k];
}

}  // namespace

void ElementMaker::shift(ElementArrays& elements, std::size_t k, std::size_t axis, double way) {
  double& lower = elements.lower[axis][k];
  lower = numbers_.fitted(lower + way);
  if (elements.shape == Shape::sphere) return;
  double& upper = elements.upper[axis][k];
  upper = std::max(lower, numbers_.fitted(upper + way));
}

/// Moves the last element, which lies at `other`, until it touches there: exactly, where the
/// numbers allow it, or by a last place not.
void ElementMaker::place_beside(ElementArrays& elements, std::size_t other) {
  const std::size_t last = elements.size() - 1;
  const std::size_t axis = reader_.below(axes_of(elements));
  const double apart = half_side(elements, last, axis) + half_side(elements, other, axis) + margin_;
  const double old = elements.lower[axis][last];
  const double there = numbers_.nudged(numbers_.fitted(reader_.flag() ? old + apart : old - apart));
  if (elements.shape == Shape::sphere) {
    elements.lower[axis][last] = there;
  } else {
    shift(elements, last, axis, there - old);
  }
}

void ElementMaker::add(ElementArrays& elements, double common_radius, double expanse) {
  const std::size_t before = elements.size();
  const std::size_t mode = before == 0 ? 0 : reader_.below(8);
  const std::size_t other = mode >= 5 ? reader_.byte() % before : 0;
  if (elements.shape == Shape::sphere) {
    // Where there are many, most are small.
    const double part = expanse > 1.0 ? 0x1p-4 : 1.0;
    const double radius = common_radius >= 0.0 ? common_radius : numbers_.size();
    elements.radius.push_back(numbers_.fitted(part * radius));
  }
  for (std::size_t axis = 0; axis < axes_of(elements); ++axis) {
    const double place = mode >= 5
                             ? elements.lower[axis][other]
                             : numbers_.fitted(expanse * numbers_.number() + numbers_.number());
    elements.lower[axis].push_back(place);
    if (elements.shape == Shape::sphere) continue;
    elements.upper[axis].push_back(std::max(place, numbers_.fitted(place + numbers_.size())));
  }
  if (mode == 6) place_beside(elements, other);
  if (mode == 7) {
    const std::size_t k = reader_.below(axes_of(elements));
    const double times = reader_.signed_byte();
    for (std::size_t axis = 0; axis < axes_of(elements); ++axis) {
      shift(elements, before, axis, times * domain_.component(k, axis));
    }
    if (reader_.flag()) place_beside(elements, before);
  }
}

void ElementMaker::move(ElementArrays& elements) {
  const std::size_t kind = reader_.below(6);
  const std::size_t step = reader_.below(4) + 1;
  for (std::size_t k = 0; k < elements.size(); k += step) {
    const std::size_t axis = reader_.below(axes_of(elements));
    if (kind == 0) {
      const std::size_t vector = reader_.below(axes_of(elements));
      for (std::size_t a = 0; a < axes_of(elements); ++a) {
        shift(elements, k, a, domain_.component(vector, a));
      }
    } else if (kind == 1) {
      shift(elements, k, axis, numbers_.number());
    } else if (kind == 2 && elements.shape == Shape::sphere) {
      elements.radius[k] = numbers_.fitted(elements.radius[k] * 1.0625);
    } else {
      shift(elements, k, axis, numbers_.number() / 256.0);
    }
  }
}

void remove_element(ElementArrays& elements, std::size_t k) {
  const auto take_last = [k](std::vector<double>& values) {
    if (values.empty()) return;
    values[k] = values.back();
    values.pop_back();
  };
  for (auto& column : elements.lower) take_last(column);
  for (auto& column : elements.upper) take_last(column);
  take_last(elements.radius);
}

}  // namespace abut::fuzz
