// What must not compile, each with a twin that must: views keep no copy, so temporaries that own
// their numbers are refused, and so is what does not lie in memory as numbers in a row.

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <array>
#include <list>
#include <span>
#include <vector>

namespace abut::testing {
namespace {

using Doubles = std::vector<double>;
using Floats = std::vector<float>;

template <class X, class Y, class Z, class R>
concept MakesSpheres = requires(X&& x, Y&& y, Z&& z, R&& r) {
  abut::spheres(static_cast<X&&>(x), static_cast<Y&&>(y), static_cast<Z&&>(z), static_cast<R&&>(r));
};
template <class X, class Y, class R>
concept MakesDiscs = requires(X&& x, Y&& y, R&& r) {
  abut::discs(static_cast<X&&>(x), static_cast<Y&&>(y), static_cast<R&&>(r));
};
template <class P, class R>
concept MakesSpheresOfPoints = requires(P&& p, R&& r) {
  abut::spheres(static_cast<P&&>(p), static_cast<R&&>(r));
};
template <class P, class R>
concept MakesDiscsOfPoints = requires(P&& p, R&& r) {
  abut::discs(static_cast<P&&>(p), static_cast<R&&>(r));
};

// Lvalues, const or not, and views.
static_assert(MakesSpheres<Doubles&, Doubles&, Doubles&, Doubles&>);
static_assert(MakesSpheres<const Doubles&, const Doubles&, const Doubles&, const Doubles&>);
static_assert(MakesSpheres<Doubles&, Doubles&, Doubles&, double>);
static_assert(MakesSpheres<Doubles&, Doubles&, Doubles&, int>);
static_assert(MakesSpheres<Floats&, Floats&, Floats&, Floats&>);
static_assert(MakesSpheres<std::span<const double>, std::span<double>, Doubles&, Column<double>>);
static_assert(MakesDiscs<double (&)[5], std::array<double, 5>&, Doubles&>);

// Temporaries that own their numbers, in every place.
static_assert(!MakesSpheres<Doubles, Doubles&, Doubles&, Doubles&>);
static_assert(!MakesSpheres<Doubles&, Doubles, Doubles&, Doubles&>);
static_assert(!MakesSpheres<Doubles&, Doubles&, Doubles, Doubles&>);
static_assert(!MakesSpheres<Doubles&, Doubles&, Doubles&, Doubles>);
static_assert(!MakesDiscs<Doubles, Doubles&, double>);
static_assert(!MakesDiscs<std::array<double, 5>, Doubles&, double>);

// Mixed or other number types, and ranges that are not in a row.
static_assert(!MakesSpheres<Doubles&, Floats&, Doubles&, Doubles&>);
static_assert(!MakesSpheres<Doubles&, Doubles&, Doubles&, Floats&>);
static_assert(!MakesDiscs<std::vector<int>&, std::vector<int>&, double>);
static_assert(!MakesDiscs<std::list<double>&, std::list<double>&, double>);
static_assert(!MakesDiscs<std::vector<long double>&, std::vector<long double>&, double>);

// Points.
using Points = std::vector<std::array<double, 3>>;
using Points2 = std::vector<std::array<float, 2>>;
static_assert(MakesSpheresOfPoints<Points&, Doubles&>);
static_assert(MakesSpheresOfPoints<const Points&, double>);
static_assert(MakesSpheresOfPoints<double (&)[7][3], double>);
static_assert(MakesDiscsOfPoints<Points2&, Floats&>);
static_assert(MakesDiscsOfPoints<Points&, Doubles&>, "z is left out");
static_assert(!MakesSpheresOfPoints<Points, double>);
static_assert(!MakesSpheresOfPoints<Points2&, Floats&>, "two numbers are no point in space");
static_assert(!MakesSpheresOfPoints<Points&, Floats&>);
// Points that hold their numbers elsewhere.
static_assert(!MakesSpheresOfPoints<std::vector<Doubles>&, double>);
static_assert(!MakesDiscsOfPoints<std::vector<std::span<double>>&, double>);

/// A linear-algebra library's vector: not trivially copyable, yet three numbers in a row.
struct Vector3 {
  Vector3() = default;
  Vector3(const Vector3& other) : numbers{other.numbers[0], other.numbers[1], other.numbers[2]} {}
  Vector3& operator=(const Vector3&) = default;
  double& operator[](std::size_t k) { return numbers[k]; }
  const double& operator[](std::size_t k) const { return numbers[k]; }
  double numbers[3]{};
};
static_assert(MakesSpheresOfPoints<std::vector<Vector3>&, double>);

struct Particle {
  double x, y, z, radius;
  float mass;
  int kind;
};
template <class R, class M>
concept MakesColumn = requires(R&& range, M member) {
  abut::column(static_cast<R&&>(range), member);
};
static_assert(MakesColumn<std::vector<Particle>&, double Particle::*>);
static_assert(MakesColumn<std::vector<Particle>&, float Particle::*>);
static_assert(!MakesColumn<std::vector<Particle>&, int Particle::*>);
static_assert(!MakesColumn<std::vector<Particle>, double Particle::*>);

TEST(Views, DescribeWhatTheyWereMadeOf) {
  Doubles x{1, 2}, y{3, 4}, r{5, 6};
  const ElementView discs = abut::discs(x, y, r);
  EXPECT_EQ(discs.size(), 2U);
  EXPECT_EQ(discs.dimensions(), 2);
  EXPECT_EQ(discs.precision(), Precision::float64);
  EXPECT_FALSE(discs.has_common_radius());

  Floats f{1, 2};
  const ElementView spheres = abut::spheres(f, f, f, 0.5);
  EXPECT_EQ(spheres.dimensions(), 3);
  EXPECT_EQ(spheres.precision(), Precision::float32);
  EXPECT_TRUE(spheres.has_common_radius());
  EXPECT_EQ(spheres.common_radius(), 0.5);
}

TEST(Views, EmptyOnesAreViews) {
  const Doubles none;
  const Points no_points;
  std::vector<Particle> no_particles;
  EXPECT_TRUE(find_contact_pairs(discs(none, none, none)).empty());
  EXPECT_TRUE(find_contact_pairs(spheres(none, none, none, 1.0)).empty());
  EXPECT_TRUE(find_contact_pairs(spheres(no_points, 1.0)).empty());
  const auto x = column(no_particles, &Particle::x);
  EXPECT_TRUE(find_contact_pairs(discs(x, x, x)).empty());
}

/// Numbers are read when a detection runs, not when the view is made.
TEST(Views, SeeLaterChanges) {
  Doubles x{0, 5}, y{0, 0};
  const ElementView elements = discs(x, y, 1.0);
  EXPECT_EQ(find_contact_pairs(elements).size(), 0U);
  x[1] = 2;
  EXPECT_EQ(find_contact_pairs(elements).size(), 1U);
}

}  // namespace
}  // namespace abut::testing
