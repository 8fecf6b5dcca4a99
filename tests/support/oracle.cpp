#include "support/oracle.hpp"

#include <gmpxx.h>

namespace abut::testing {
namespace {

enum class Verdict { apart, within, unclear };

/// Rounding moves either side by less than 2^-49 of itself as long as no square leaves the range
/// of normal numbers; the band is 2^-39.
Verdict judge_in_double(const scenes::Scene& scene, std::size_t i, std::size_t j, double margin) {
  const double reach = scene.radius[i] + scene.radius[j] + margin;
  const double dx = scene.x[i] - scene.x[j];
  const double dy = scene.y[i] - scene.y[j];
  const double dz = scene.dimensions == 3 ? scene.z[i] - scene.z[j] : 0.0;
  const double distance_squared = dx * dx + dy * dy + dz * dz;
  const double reach_squared = reach * reach;
  if (!(reach_squared > 1e-200) || !(reach_squared < 1e200)) return Verdict::unclear;
  if (distance_squared > reach_squared * (1.0 + 0x1p-39)) return Verdict::apart;
  if (distance_squared < reach_squared * (1.0 - 0x1p-39)) return Verdict::within;
  return Verdict::unclear;
}

}  // namespace

bool rational_contact(const scenes::Scene& scene, std::size_t i, std::size_t j, double margin) {
  mpq_class slack = mpq_class(scene.radius[i]) + mpq_class(scene.radius[j]) + mpq_class(margin);
  slack *= slack;
  for (const std::vector<double>* axis : {&scene.x, &scene.y, &scene.z}) {
    if (axis->empty()) continue;
    mpq_class difference = mpq_class((*axis)[i]) - mpq_class((*axis)[j]);
    slack -= difference * difference;
  }
  return sgn(slack) >= 0;
}

PairVector oracle_pairs(const scenes::Scene& scene, double margin) {
  PairVector pairs;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.size(); ++j) {
      const Verdict verdict = judge_in_double(scene, i, j, margin);
      if (verdict == Verdict::apart) continue;
      if (verdict == Verdict::unclear && !rational_contact(scene, i, j, margin)) continue;
      pairs.push_back({static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)});
    }
  }
  return pairs;
}

}  // namespace abut::testing
