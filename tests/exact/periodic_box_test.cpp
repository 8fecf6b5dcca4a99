// The predicate of boxes with a lattice between them, and their gap, against rational numbers.

#include "exact/periodic_box.hpp"

#include "exact/far_images.hpp"
#include "exact/hard_pairs.hpp"
#include "support/dimensions.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <random>
#include <utility>

namespace abut::testing {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

template <int Dim>
struct BoxPair {
  std::array<exact::Box<Dim>, 2> box{};
  exact::Lattice lattice;
  ImageShift shift;
  double margin = 0.0;

  friend std::ostream& operator<<(std::ostream& out, const BoxPair& pair) {
    out << std::hexfloat;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      out << "axis " << axis << ": ";
      for (const auto& one : pair.box) out << one.lower[axis] << " to " << one.upper[axis] << ", ";
      for (std::size_t k = 0; k < Dim; ++k) {
        out << (pair.lattice.periodic[k] ? " vector " : " (open) ")
            << pair.lattice.vectors[k][axis];
      }
      out << "; ";
    }
    return out << "margin " << pair.margin << std::defaultfloat << ", shift " << pair.shift.x << ' '
               << pair.shift.y << ' ' << pair.shift.z;
  }
};

/// n A on an axis.
template <int Dim>
mpq_class moved_by(const BoxPair<Dim>& pair, std::size_t axis) {
  mpq_class moved = 0;
  for (std::size_t k = 0; k < Dim; ++k) {
    if (!pair.lattice.periodic[k]) continue;
    moved += exact::numbers(pair.shift)[k] * mpq_class(pair.lattice.vectors[k][axis]);
  }
  return moved;
}

/// The largest separation over the axes.
template <int Dim>
mpq_class exact_gap(const BoxPair<Dim>& pair) {
  const auto& [a, b] = pair.box;
  mpq_class result;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const mpq_class moved = moved_by(pair, axis);
    const mpq_class a_behind = mpq_class(a.lower[axis]) - mpq_class(b.upper[axis]) - moved;
    const mpq_class b_behind = mpq_class(b.lower[axis]) + moved - mpq_class(a.upper[axis]);
    if (axis == 0 || a_behind > result) result = a_behind;
    if (b_behind > result) result = b_behind;
  }
  return result;
}

template <int Dim>
BoxPair<Dim> exchanged(BoxPair<Dim> pair) {
  std::swap(pair.box[0], pair.box[1]);
  pair.shift = {-pair.shift.x, -pair.shift.y, -pair.shift.z};
  return pair;
}

struct Count {
  std::uint64_t pairs = 0;
  std::uint64_t within = 0;
  std::uint64_t exact_decisions = 0;
  std::uint64_t far = 0;
};

template <int Dim>
bool decide(const BoxPair<Dim>& pair, std::uint64_t& exact_decisions) {
  return exact::within_reach(pair.box[0], pair.box[1], pair.shift, pair.lattice, pair.margin,
                             exact_decisions);
}

/// Whether `rounded` is the nearest double to `exact`, to even between two; the largest stands for
/// all beyond.
bool is_rounded(const mpq_class& exact, double rounded) {
  if (std::fabs(rounded) == largest) return abs(exact) >= mpq_class(std::nextafter(largest, 0.0));
  const mpq_class value(rounded);
  const mpq_class above = (value + mpq_class(std::nextafter(rounded, HUGE_VAL))) / 2;
  const mpq_class below = (value + mpq_class(std::nextafter(rounded, -HUGE_VAL))) / 2;
  return below <= exact && exact <= above;
}

/// Stops at the first pair that is decided otherwise than by the rational numbers.
template <int Dim>
void compare(const BoxPair<Dim>& pair, Count& count) {
  const mpq_class gap = exact_gap(pair);
  const bool expected = gap <= mpq_class(pair.margin);
  std::uint64_t again = 0;
  ASSERT_EQ(decide(pair, count.exact_decisions), expected) << pair;
  ASSERT_EQ(decide(exchanged(pair), again), expected) << "exchanged: " << pair;
  const exact::LatticeSteps<Dim> steps(pair.shift, pair.lattice);
  ASSERT_EQ(exact::within_reach_exactly(pair.box[0], pair.box[1], steps, pair.margin), expected)
      << pair;
  for (const int bits : {0, 61, 92}) {
    const auto far = by_shorter_vectors(pair.lattice, pair.shift, bits);
    if (!far) continue;
    ASSERT_EQ(exact::far_image_within_reach(pair.box[0], pair.box[1], far->shift, far->lattice,
                                            pair.margin),
              expected)
        << pair << " by " << bits << " bits";
    ++count.far;
  }
  const double computed = exact::gap(pair.box[0], pair.box[1], pair.shift, pair.lattice);
  ASSERT_TRUE(is_rounded(gap, computed)) << computed << ": " << pair;
  ASSERT_EQ(computed <= 0.0, gap <= 0) << computed << ": " << pair;
  ASSERT_FALSE(computed == 0.0 && std::signbit(computed)) << pair;
  const auto back = exchanged(pair);
  ASSERT_EQ(computed, exact::gap(back.box[0], back.box[1], back.shift, back.lattice)) << pair;
  count.within += expected ? 1 : 0;
  ++count.pairs;
}

std::int32_t random_number_of_cells(Random& random, int bits) {
  const auto limit = (std::int64_t{1} << bits) - 1;
  return static_cast<std::int32_t>(
      std::uniform_int_distribution<std::int64_t>(-limit, limit)(random));
}

template <int Dim>
void choose_lattice(BoxPair<Dim>& pair, int bits, bool coarse, Random& random) {
  const std::size_t always = random.below(Dim);
  for (std::size_t k = 0; k < Dim; ++k) {
    pair.lattice.periodic[k] = k == always || random.below(2) == 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      // Mostly as in orthogonal and triangular cells, with zeros.
      const bool zero = axis != k && random.below(2) == 0;
      pair.lattice.vectors[k][axis] = zero     ? 0.0
                                      : coarse ? short_number(random, 8)
                                               : random.uniform(-1.0, 1.0);
    }
  }
  pair.shift.x = random_number_of_cells(random, bits);
  pair.shift.y = random_number_of_cells(random, bits);
  if constexpr (Dim == 3) pair.shift.z = random_number_of_cells(random, bits);
}

/// Boxes that overlap well on all axes but one, where the image of the second begins behind the
/// end of the first by the margin, give or take a few last places: n A cancels almost all.
template <int Dim>
BoxPair<Dim> cancelling_pair(Random& random, int bits) {
  BoxPair<Dim> pair;
  const bool coarse = random.below(3) == 0;
  choose_lattice(pair, bits, coarse, random);
  const std::size_t tight = random.below(Dim);
  const auto number = [&](double size) {
    return coarse ? short_number(random, 8) * size : random.uniform(-size, size);
  };
  pair.margin = random.below(3) == 0 ? 0.0 : std::fabs(number(1.0));
  auto& [a, b] = pair.box;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    a.lower[axis] = number(1.0);
    a.upper[axis] = a.lower[axis] + std::fabs(number(1.0));
    const mpq_class moved = moved_by(pair, axis);
    const bool behind = random.below(2) == 0;
    mpq_class end = behind ? mpq_class(a.upper[axis]) : mpq_class(a.lower[axis]);
    end += behind ? mpq_class(pair.margin) : mpq_class(-pair.margin);
    end -= moved;
    const double rounded = moved_by_ulps(end.get_d(), static_cast<int>(random.below(5)) - 2);
    const double width = 0.5 + std::fabs(number(1.0));
    const double inside = axis == tight ? 0.0 : 0.25 * width;
    b.lower[axis] = behind ? rounded - inside : rounded + inside - width;
    b.upper[axis] = behind ? rounded + width : rounded + inside;
    if (axis == tight) (behind ? b.lower : b.upper)[axis] = rounded;
  }
  if (random.below(2) == 0) std::swap(pair.box[0], pair.box[1]);
  return pair;
}

template <int Dim>
void scale(BoxPair<Dim>& pair, int exponent) {
  for (auto& box : pair.box) {
    for (double& x : box.lower) x = std::ldexp(x, exponent);
    for (double& x : box.upper) x = std::ldexp(x, exponent);
  }
  for (auto& vector : pair.lattice.vectors) {
    for (double& x : vector) x = std::ldexp(x, exponent);
  }
  pair.margin = std::ldexp(pair.margin, exponent);
}

template <class Dimension>
class PeriodicBoxes : public ::testing::Test {};

TYPED_TEST_SUITE(PeriodicBoxes, Dimensions);

TYPED_TEST(PeriodicBoxes, CancellationAtEveryNumberOfCells) {
  Random random(171);
  for (const int bits : {1, 4, 10, 20, 31}) {
    Count count;
    for (int k = 0; k < 4000; ++k) {
      ASSERT_NO_FATAL_FAILURE(compare(cancelling_pair<TypeParam::value>(random, bits), count))
          << bits << " bits";
    }
    EXPECT_GT(count.exact_decisions, count.pairs / 4) << "the slow path must be reached";
    EXPECT_GT(count.within, count.pairs / 5) << bits;
    EXPECT_LT(count.within, count.pairs * 4 / 5) << bits;
    EXPECT_EQ(count.far, count.pairs * 3) << bits;
  }
}

TYPED_TEST(PeriodicBoxes, CancellationAtEveryScale) {
  Random random(172);
  Count count;
  for (int exponent = -1074; exponent <= 990; exponent += 6) {
    for (int k = 0; k < 20; ++k) {
      auto pair = cancelling_pair<TypeParam::value>(random, 1 + static_cast<int>(random.below(31)));
      scale(pair, exponent);
      ASSERT_NO_FATAL_FAILURE(compare(pair, count)) << "2^" << exponent;
    }
  }
  EXPECT_GT(count.exact_decisions, count.pairs / 4);
}

TYPED_TEST(PeriodicBoxes, ExtremeNumbers) {
  constexpr int dim = TypeParam::value;
  Random random(173);
  Count count;
  for (int round = 0; round < 20000; ++round) {
    BoxPair<dim> pair;
    choose_lattice(pair, random.below(2) == 0 ? 31 : 2, true, random);
    for (std::size_t axis = 0; axis < dim; ++axis) {
      for (auto& box : pair.box) {
        const double ends[2] = {extreme_number(random), extreme_number(random)};
        box.lower[axis] = std::fmin(ends[0], ends[1]);
        box.upper[axis] = std::fmax(ends[0], ends[1]);
      }
      for (std::size_t k = 0; k < dim; ++k) {
        pair.lattice.vectors[k][axis] = random.below(4) == 0 ? 0.0 : extreme_number(random);
      }
    }
    pair.margin = random.below(2) == 0 ? 0.0 : std::fabs(extreme_number(random));
    ASSERT_NO_FATAL_FAILURE(compare(pair, count));
  }
  EXPECT_GT(count.within, 1000U);
  EXPECT_LT(count.within, count.pairs);
}

TYPED_TEST(PeriodicBoxes, TheFilterDecidesWhatIsClear) {
  Random random(174);
  Count count;
  for (int k = 0; k < 10000; ++k) {
    auto pair = cancelling_pair<TypeParam::value>(random, 4);
    const double off = random.below(2) == 0 ? 1e-9 : -1e-9;
    for (double& x : pair.box[1].lower) x -= off;
    for (double& x : pair.box[1].upper) x += off;
    ASSERT_NO_FATAL_FAILURE(compare(pair, count));
  }
  EXPECT_LT(count.exact_decisions, count.pairs / 100);
  EXPECT_GT(count.within, count.pairs / 4);
}

/// The filter with another band, to see that these pairs need the one it has.
TYPED_TEST(PeriodicBoxes, ANarrowerBandWouldBeWrong) {
  constexpr int dim = TypeParam::value;
  Random random(175);
  std::uint64_t wrong = 0;
  for (int k = 0; k < 60000; ++k) {
    const auto pair = cancelling_pair<dim>(random, 6);
    const auto& [a, b] = pair.box;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      double moved = 0.0;
      double magnitude = 0.0;
      for (const auto& step : exact::LatticeSteps<dim>(pair.shift, pair.lattice)) {
        moved += step.number * step.vector[axis];
        magnitude += std::fabs(step.number * step.vector[axis]);
      }
      if (magnitude == 0.0) continue;
      magnitude += std::fabs(a.lower[axis]) + std::fabs(a.upper[axis]) + std::fabs(b.lower[axis]) +
                   std::fabs(b.upper[axis]) + pair.margin;
      const double computed = ((a.lower[axis] - b.upper[axis]) - moved) - pair.margin;
      const mpq_class exact = mpq_class(a.lower[axis]) - mpq_class(b.upper[axis]) -
                              moved_by(pair, axis) - mpq_class(pair.margin);
      const mpq_class error = abs(mpq_class(computed) - exact);
      ASSERT_LT(error, mpq_class(exact::box_band * magnitude)) << pair;
      wrong += error > mpq_class(exact::box_band / 16 * magnitude) ? 1 : 0;
    }
  }
  EXPECT_GT(wrong, 0U);
}

TYPED_TEST(PeriodicBoxes, TheLargestShifts) {
  constexpr int dim = TypeParam::value;
  for (const std::int32_t number :
       {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()}) {
    BoxPair<dim> pair;
    pair.lattice.vectors[0] = {1.0, 0.0, 0.0};
    pair.lattice.periodic[0] = true;
    pair.shift.x = number;
    pair.box[0].upper[0] = 0.25;
    pair.box[1].lower[0] = 0.25 - number;
    pair.box[1].upper[0] = 0.75 - number;
    std::uint64_t undecided = 0;
    EXPECT_TRUE(decide(pair, undecided)) << pair;
    EXPECT_EQ(exact::gap(pair.box[0], pair.box[1], pair.shift, pair.lattice), 0.0);
    pair.box[0].upper[0] = std::nextafter(0.25, 0.0);
    EXPECT_FALSE(decide(pair, undecided)) << pair;
    EXPECT_GT(exact::gap(pair.box[0], pair.box[1], pair.shift, pair.lattice), 0.0);
    EXPECT_EQ(undecided, 2U);
  }
}

TYPED_TEST(PeriodicBoxes, VectorsOfOpenAxesMeanNothing) {
  constexpr int dim = TypeParam::value;
  BoxPair<dim> pair;
  pair.box[1].lower[0] = pair.box[1].upper[0] = 9.0;
  pair.lattice.vectors[0] = {9.0, 0.0, 0.0};
  pair.lattice.vectors[1] = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
  pair.lattice.periodic[0] = true;
  std::uint64_t undecided = 0;
  pair.shift = {-1, 5, 0};
  EXPECT_TRUE(decide(pair, undecided));
  pair.shift = {0, 5, 0};
  EXPECT_FALSE(decide(pair, undecided));
  EXPECT_EQ(exact::gap(pair.box[0], pair.box[1], pair.shift, pair.lattice),
            exact::gap(pair.box[0], pair.box[1]));
}

TEST(PeriodicBoxGap, PlainNumbersAndTheLargest) {
  exact::Lattice lattice;
  lattice.vectors = {{{10, 0, 0}, {0, 20, 0}, {}}};
  lattice.periodic = {true, true, false};
  const exact::Box<2> a{{1, 1}, {2, 2}};
  const exact::Box<2> b{{8, 17}, {9, 18}};
  EXPECT_EQ(exact::gap(a, b, {-1, -1, 0}, lattice), 3.0);
  EXPECT_EQ(exact::gap(a, b, {-1, 0, 0}, lattice), 15.0);
  EXPECT_EQ(exact::gap(a, a, {1, 0, 0}, lattice), 9.0);
  lattice.vectors[0][0] = largest;
  EXPECT_EQ(exact::gap(a, b, {std::numeric_limits<std::int32_t>::max(), 0, 0}, lattice), largest);
  const exact::Box<2> all{{-largest, -largest}, {largest, largest}};
  EXPECT_EQ(exact::gap(all, all, {0, 1, 0}, lattice), -largest);
}

}  // namespace
}  // namespace abut::testing
