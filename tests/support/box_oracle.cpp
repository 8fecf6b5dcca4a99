#include "support/box_oracle.hpp"

#include <gmpxx.h>

#include <array>
#include <cmath>

namespace abut::testing {
namespace {

bool at_most(double a, double b, double margin) {
  const double excess = a - b - margin;
  const double doubt = 1e-12 * (std::fabs(a) + std::fabs(b) + margin);
  if (excess < -doubt || excess > doubt) return excess < 0.0;
  return mpq_class(a) <= mpq_class(b) + mpq_class(margin);
}

bool box_contact(const scenes::BoxScene& scene, std::size_t i, std::size_t j, double margin) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
    if (!at_most(scene.lower[axis][i], scene.upper[axis][j], margin)) return false;
    if (!at_most(scene.lower[axis][j], scene.upper[axis][i], margin)) return false;
  }
  return true;
}

}  // namespace

PairVector oracle_pairs(const scenes::BoxScene& scene, double margin) {
  PairVector pairs;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.size(); ++j) {
      if (!box_contact(scene, i, j, margin)) continue;
      pairs.push_back({static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)});
    }
  }
  return pairs;
}

}  // namespace abut::testing
