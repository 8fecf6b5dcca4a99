#include "fuzz/check_geometry.hpp"

#include <abut/measure.hpp>
#include <abut/simd.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace abut::fuzz {
namespace {

constexpr std::size_t most_compared = 12;  ///< rational numbers take their time

struct Pairs {
  explicit Pairs(const Question& question) {
    for (const auto& [pair, shift] : question.expected().pairs) {
      pairs.push_back(pair);
      shifts.push_back(shift);
    }
  }

  [[nodiscard]] PairSpans spans() const { return {pairs, shifts}; }

  std::vector<ContactPair> pairs;
  std::vector<ImageShift> shifts;
};

PairGeometry measured(const Question& question, const Pairs& pairs, Simd simd) {
  const Quantities all =
      Quantity::gap | Quantity::normal | Quantity::point | Quantity::distance | Quantity::vector;
  const Options options{.threads = 1, .simd = simd};
  return question.has_two_sets()
             ? measure(question.first(), question.second(), pairs.spans(), all, question.domain(),
                       options)
             : measure(question.first(), pairs.spans(), all, question.domain(), options);
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const Vector& a, const Vector& b) {
  return same_bits(a[0], b[0]) && same_bits(a[1], b[1]) && same_bits(a[2], b[2]);
}

[[noreturn]] void fail(const char* quantity, std::size_t k, const std::string& what) {
  throw Failure(std::string(quantity) + " of pair " + std::to_string(k) + " " + what);
}

template <class T>
void require_same(const char* quantity, std::span<const T> a, std::span<const T> b, Simd simd) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!same_bits(a[k], b[k]))
      fail(quantity, k, "has other bits from " + std::string(name_of(simd)));
  }
}

void require_same(const PairGeometry& a, const PairGeometry& b, Simd simd) {
  require_same<double>("gap", a.gaps, b.gaps, simd);
  require_same<Vector>("normal", a.normals, b.normals, simd);
  require_same<Vector>("point", a.points, b.points, simd);
  require_same<double>("distance", a.distances, b.distances, simd);
  require_same<Vector>("vector", a.vectors, b.vectors, simd);
}

/// Bounds of normals, points and distances of boxes are not those of spheres, and are tested with
/// the geometry of contacts.
void require_right(const Question& question, const PairGeometry& geometry) {
  const testing::ExactOracle oracle = question.oracle();
  const std::vector<ImagePair>& pairs = question.expected().pairs;
  const bool spheres = question.system().first.shape == Shape::sphere;
  for (std::size_t k = 0; k < pairs.size(); k += pairs.size() / most_compared + 1) {
    const ImagePair image = question.in_oracle(pairs[k]);
    const auto& [pair, n] = pairs[k];
    const double alone = question.has_two_sets()
                             ? gap(question.first(), question.second(), question.domain(), pair, n)
                             : gap(question.first(), question.domain(), pair, n);
    const double found = geometry.gaps[k];
    if (!same_bits(alone, found)) fail("gap", k, "is not that of the pair alone");
    if (!oracle.is_gap(image, found)) fail("gap", k, "is " + std::to_string(found));
    if (!spheres) continue;
    if (!oracle.is_distance(image, geometry.distances[k])) fail("distance", k, "is wrong");
    if (!oracle.is_normal(image, geometry.normals[k])) fail("normal", k, "is wrong");
    if (!oracle.is_point(image, geometry.points[k])) fail("point", k, "is wrong");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!oracle.is_component(image, axis, -geometry.vectors[k][axis])) {
        fail("vector", k, "is wrong");
      }
    }
  }
}

}  // namespace

void check_geometry(const Question& question) {
  const Pairs pairs(question);
  const PairGeometry geometry = measured(question, pairs, Simd::scalar);
  for (const Simd simd : simd_levels()) {
    if (simd != Simd::scalar && available(simd)) {
      require_same(geometry, measured(question, pairs, simd), simd);
    }
  }
  require_right(question, geometry);
}

}  // namespace abut::fuzz
