#pragma once

#include "benchmarks/common/bounds.hpp"
#include "scenes/scene.hpp"

#include <abut/pair.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Elements and pairs of those contestants that build boxes or trees of a library and then test the
/// candidate pairs which it proposes.
namespace abut::benchmarks {

/// An element in one piece of memory; discs lie at z = 0.
struct PackedElement {
  std::array<double, 3> center{};
  double radius = 0.0;
};

/// The plain test in double, which may err where elements touch to within a few last places.
[[nodiscard]] inline bool touching(const PackedElement& a, const PackedElement& b) {
  const double x = a.center[0] - b.center[0];
  const double y = a.center[1] - b.center[1];
  const double z = a.center[2] - b.center[2];
  const double reach = a.radius + b.radius;
  return x * x + y * y + z * z <= reach * reach;
}

/// The box of an element on one axis, so much wider than the element that rounding loses no pair.
[[nodiscard]] inline Bounds<double> bounds(const PackedElement& element, std::size_t axis) {
  const double x = element.center[axis];
  const double half = element.radius + (std::abs(x) + element.radius) * 0x1p-50;
  return {x - half, x + half};
}

/// The same for libraries that compute in float.
[[nodiscard]] inline Bounds<float> float_bounds(const PackedElement& element, std::size_t axis) {
  return float_bounds(bounds(element, axis));
}

/// The elements of a scene, one after the other, and the pairs found among them. The memory stays
/// from run to run.
class Packed {
 public:
  void pack(const scenes::Scene& scene) {
    elements_.resize(scene.size());
    for (std::size_t k = 0; k < scene.size(); ++k) {
      const double z = scene.dimensions == 3 ? scene.z[k] : 0.0;
      elements_[k] = {{scene.x[k], scene.y[k], z}, scene.radius[k]};
    }
    pairs_.clear();
    candidates_ = 0;
  }

  [[nodiscard]] std::size_t size() const { return elements_.size(); }
  [[nodiscard]] const PackedElement& operator[](std::size_t k) const { return elements_[k]; }

  /// Tests a candidate pair that comes once.
  void propose(ElementIndex a, ElementIndex b) {
    ++candidates_;
    if (touching(elements_[a], elements_[b])) keep(a, b);
  }

  void keep(ElementIndex a, ElementIndex b) { pairs_.push_back({std::min(a, b), std::max(a, b)}); }

  [[nodiscard]] const std::vector<ContactPair>& pairs() const { return pairs_; }
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }

 private:
  std::vector<PackedElement> elements_;
  std::vector<ContactPair> pairs_;
  std::uint64_t candidates_ = 0;
};

}  // namespace abut::benchmarks
