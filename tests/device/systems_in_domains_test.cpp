// Small random systems in domains of every kind, where borderline pairs are common, through the
// device engine: spheres and boxes, one set and two, against whole numbers.

#include "device/domain_answers.hpp"
#include "properties/systems.hpp"
#include "support/exact_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

/// That of the relations, which are in the same program.
[[maybe_unused]] const int fixed_seed = ::setenv("RC_PARAMS", "seed=20040101 max_success=150", 0);

enum class Space { open, some_axes, all_axes, oblique, sheared };
constexpr std::array spaces{Space::open, Space::some_axes, Space::all_axes, Space::oblique,
                            Space::sheared};

/// A whole number from begin to end - 1, all alike.
rc::Gen<int> whole(int begin, int end) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(begin, end));
}

/// Vectors of whole units. Some are shorter than the reach, and elements lie some cells away.
Domain any_domain(Space space, int dimensions, double unit) {
  if (space == Space::open) return Domain::open();
  std::array<Domain::Vector, 3> vectors{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // The side along its own axis is longer than the others together: no vectors are dependent.
      if (axis == k) vectors[k][axis] = unit * *whole(7, 31);
      if (axis != k && space == Space::oblique) vectors[k][axis] = unit * *whole(-3, 4);
    }
  }
  if (space == Space::sheared) vectors[1][0] = unit * *whole(-100, 101);
  auto axes = dimensions == 2 ? Axes::xy : Axes::xyz;
  if (space == Space::some_axes) {
    axes = dimensions == 2
               ? *rc::gen::element(Axes::x, Axes::y)
               : *rc::gen::element(Axes::x, Axes::y, Axes::z, Axes::xy, Axes::xz, Axes::yz);
  }
  const auto& [a, b, c] = vectors;
  return dimensions == 2 ? Domain::lattice({a[0], a[1]}, {b[0], b[1]}, axes)
                         : Domain::lattice(a, b, c, axes);
}

/// Spheres, or boxes about them whose half sides are 0 to 1.5 times the radius.
ElementArrays elements_of(const Scene& scene, Shape shape) {
  ElementArrays elements;
  elements.dimensions = scene.dimensions;
  elements.shape = shape;
  elements.lower = {scene.x, scene.y, scene.z};
  if (shape == Shape::sphere) {
    elements.radius = scene.radius;
    return elements;
  }
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
    for (std::size_t k = 0; k < scene.size(); ++k) {
      const double half = 0.5 * static_cast<double>((k + axis) % 4) * scene.radius[k];
      elements.upper[axis].push_back(elements.lower[axis][k] + half);
      elements.lower[axis][k] -= half;
    }
  }
  return elements;
}

/// Elements begin to end - 1 as numbers of type T.
template <class T>
class NumbersOf {
 public:
  NumbersOf(const ElementArrays& all, std::size_t begin, std::size_t end)
      : dimensions_(all.dimensions), shape_(all.shape) {
    const auto copy = [&](std::vector<T>& to, const std::vector<double>& from) {
      if (from.empty()) return;
      for (std::size_t k = begin; k < end; ++k) to.push_back(static_cast<T>(from[k]));
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      copy(lower_[axis], all.lower[axis]);
      copy(upper_[axis], all.upper[axis]);
    }
    copy(radius_, all.radius);
  }

  [[nodiscard]] ElementView view() const {
    const auto& [x, y, z] = lower_;
    const auto& [xmax, ymax, zmax] = upper_;
    if (shape_ == Shape::box) {
      return dimensions_ == 2 ? rectangles(x, y, xmax, ymax) : boxes(x, y, z, xmax, ymax, zmax);
    }
    return dimensions_ == 2 ? discs(x, y, radius_) : spheres(x, y, z, radius_);
  }

 private:
  int dimensions_;
  Shape shape_;
  std::array<std::vector<T>, 3> lower_, upper_;
  std::vector<T> radius_;
};

bool fit_float(const ElementArrays& elements) {
  const auto fit = [](const std::vector<double>& numbers) {
    return std::ranges::all_of(
        numbers, [](double x) { return static_cast<double>(static_cast<float>(x)) == x; });
  };
  return std::ranges::all_of(elements.lower, fit) && std::ranges::all_of(elements.upper, fit) &&
         fit(elements.radius);
}

/// The answer of the oracle: of one set, or of two, which begin with the first `cut` elements.
std::vector<ImagePair> expected_of(const ElementArrays& elements, bool are_two, std::size_t cut,
                                   const Domain& domain, double margin) {
  const OracleAnswer answer = ExactOracle(elements, domain, margin).pairs(1'000'000);
  RC_ASSERT(!answer.too_many);
  if (!are_two) return answer.pairs;
  std::vector<ImagePair> across;
  for (ImagePair image : answer.pairs) {
    if (image.pair.first >= cut || image.pair.second < cut) continue;
    image.pair.second -= static_cast<ElementIndex>(cut);
    across.push_back(image);
  }
  return across;
}

PairVector without_shifts(const std::vector<ImagePair>& images) {
  PairVector pairs;
  for (const ImagePair& image : images) pairs.push_back(image.pair);
  return pairs;
}

struct Found {
  std::size_t pairs = 0;
  std::size_t through_faces = 0;
};

/// One system, as float or double, each set of its own numbers.
void check_one(const ElementArrays& elements, bool are_two, const Domain& domain, double margin,
               Found& found) {
  const std::size_t cut =
      are_two ? *rc::gen::inRange<std::size_t>(0, elements.size() + 1) : elements.size();
  const bool fits = fit_float(elements);
  const bool first_float = fits && *rc::gen::arbitrary<bool>();
  const bool second_float = fits && *rc::gen::arbitrary<bool>();
  const auto view = [](bool as_float, const auto& floats, const auto& doubles) {
    return as_float ? floats.view() : doubles.view();
  };
  const NumbersOf<float> floats(elements, 0, cut), other_floats(elements, cut, elements.size());
  const NumbersOf<double> doubles(elements, 0, cut), others(elements, cut, elements.size());
  const ElementView first = view(first_float, floats, doubles);
  const ElementView second = view(second_float, other_floats, others);

  const std::vector<ImagePair> expected = expected_of(elements, are_two, cut, domain, margin);
  const DomainAnswers answers =
      answers_in_domain(first, are_two ? &second : nullptr, domain, margin);
  RC_ASSERT(answers.counted == expected.size());
  RC_ASSERT(answers.pairs == expected);
  RC_ASSERT(answers.without_shifts == without_shifts(expected));
  for (const ImagePair& image : expected) found.through_faces += image.shift != ImageShift{};
  found.pairs += expected.size();
}

struct Kind {
  Space space;
  Shape shape;
  bool are_two;
};

std::vector<Kind> all_kinds() {
  std::vector<Kind> kinds;
  for (const Space space : spaces) {
    for (const Shape shape : {Shape::sphere, Shape::box}) {
      for (const bool are_two : {false, true}) kinds.push_back({space, shape, are_two});
    }
  }
  return kinds;
}

std::string name_of(const Kind& kind) {
  static constexpr std::array names{"open", "some_axes", "all_axes", "oblique", "sheared"};
  return std::string(kind.are_two ? "two_sets_of_" : "") +
         (kind.shape == Shape::box ? "boxes_" : "spheres_") +
         names[static_cast<std::size_t>(kind.space)];
}

class DeviceSystemsInDomains : public ::testing::TestWithParam<Kind> {};

TEST_P(DeviceSystemsInDomains, AreThoseOfTheOracle) {
  const auto [space, shape, are_two] = GetParam();
  Found found;
  EXPECT_TRUE(rc::check([&, space = space, shape = shape, are_two = are_two] {
    const double unit = *rc::gen::element(exact_unit, 0.1, 0x1.6a09e667f3bcdp-1);
    // Small ones, with which a property begins, are empty or all in one place.
    const Scene scene = *rc::gen::resize(rc::kNominalSize, system_on(unit, 24));
    const double margin = *rc::gen::element(0.0, 0.25, 0.1);
    const Domain domain = any_domain(space, scene.dimensions, unit);
    check_one(elements_of(scene, shape), are_two, domain, margin, found);
  }));
  EXPECT_GT(found.pairs, 100U);
  EXPECT_GE(found.through_faces, space == Space::open ? 0U : 100U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DeviceSystemsInDomains, ::testing::ValuesIn(all_kinds()),
                         [](const auto& parameter) { return name_of(parameter.param); });

}  // namespace
}  // namespace abut::testing
