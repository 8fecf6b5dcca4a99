#include "support/exact_oracle.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

/// The lengths that the library tells: are they rounded as the contract says?
namespace abut::testing {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

mpq_class midpoint(double a, double b) {
  return (mpq_class(a) + mpq_class(b)) / 2;
}

bool is_even(double value) {
  return std::bit_cast<std::uint64_t>(value) % 2 == 0;
}

/// Whether `rounded` is the nearest double to `exact`, to even between two; the largest beyond it.
bool is_nearest(const mpq_class& exact, double rounded) {
  if (abs(exact) >= largest) return rounded == (sgn(exact) < 0 ? -largest : largest);
  if (std::fabs(rounded) == largest) return abs(mpq_class(rounded) - exact) < 0x1p970;
  const mpq_class above = midpoint(rounded, std::nextafter(rounded, inf));
  const mpq_class below = midpoint(rounded, std::nextafter(rounded, -inf));
  if (is_even(rounded)) return below <= exact && exact <= above;
  return below < exact && exact < above;
}

/// The distance of the largest of the numbers to the next double above.
double last_place(const std::array<double, 3>& numbers) {
  const double x = std::max({std::fabs(numbers[0]), std::fabs(numbers[1]), std::fabs(numbers[2])});
  return x < largest ? std::nextafter(x, inf) - x : 0x1p971;
}

}  // namespace

mpq_class ExactOracle::length(const Vector& vector) {
  return mpq_class(sqrt(dot(vector, vector) << 256)) >> 128;
}

mpq_class ExactOracle::number(const mpz_class& whole) const {
  mpq_class result(whole);
  if (exponent_ >= 0) return result << static_cast<mp_bitcnt_t>(exponent_);
  return result >> static_cast<mp_bitcnt_t>(-exponent_);
}

bool ExactOracle::touch(const ImagePair& image) const {
  if (shape_ == Shape::box) return box_gap(image) <= 0;
  const Vector apart = difference(image);
  const mpz_class reach = sizes_[image.pair.first][0] + sizes_[image.pair.second][0];
  return dot(apart, apart) <= reach * reach;
}

mpq_class ExactOracle::box_gap(const ImagePair& image) const {
  const Vector apart = difference(image);
  mpz_class result;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions_); ++axis) {
    const mpz_class gap =
        abs(apart[axis]) - sizes_[image.pair.first][axis] - sizes_[image.pair.second][axis];
    if (axis == 0 || gap > result) result = gap;
  }
  return number(result);
}

bool ExactOracle::is_component(const ImagePair& image, std::size_t axis, double value) const {
  return is_nearest(number(difference(image)[axis]), value);
}

bool ExactOracle::is_distance(const ImagePair& image, double value) const {
  const Vector apart = difference(image);
  const mpq_class root = number(1);
  const mpq_class square = mpq_class(dot(apart, apart)) * root * root;
  if (square >= mpq_class(largest) * largest) return value == largest;
  if (value < 0.0 || !std::isfinite(value)) return false;
  const double next = std::nextafter(value, inf);
  const bool tiny = value < 0x1p-1000;
  const mpq_class above = value == largest ? mpq_class(largest) + 0x1p970
                          : tiny           ? mpq_class(next)
                                           : midpoint(value, next);
  if (square > above * above) return false;
  if (value == 0.0) return true;
  const double previous = std::nextafter(value, -inf);
  const mpq_class below = tiny ? mpq_class(previous) : midpoint(value, previous);
  return below * below < square || (tiny && below * below <= square);
}

bool ExactOracle::is_normal(const ImagePair& image, const std::array<double, 3>& value) const {
  const Vector opposite = difference(image);
  const mpq_class distance = length(opposite);
  const mpq_class most = distance * last_place(value);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(value[axis])) return false;
    if (distance == 0 && value[axis] != 0.0) return false;
    if (abs(distance * value[axis] + opposite[axis]) > most) return false;
  }
  return true;
}

bool ExactOracle::is_point(const ImagePair& image, const std::array<double, 3>& value) const {
  const auto& [i, j] = image.pair;
  const Vector opposite = difference(image);
  const mpq_class distance = length(opposite);
  const mpq_class along = distance == 0 ? mpq_class(0) : (sizes_[i][0] - sizes_[j][0]) / distance;
  mpz_class most = std::max(sizes_[i][0], sizes_[j][0]);
  for (const auto& center : {centers_[i], centers_[j]}) {
    for (const mpz_class& x : center) most = std::max<mpz_class>(most, abs(x));
  }
  const mpq_class error = (number(most) >> 94) + mpq_class(last_place(value));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(value[axis])) return false;
    const mpq_class exact = number(centers_[i][axis]) - number(opposite[axis]) * (1 + along) / 2;
    if (abs(exact) >= largest) continue;
    if (abs(exact - value[axis]) > error) return false;
  }
  return true;
}

bool ExactOracle::is_gap(const ImagePair& image, double value) const {
  if (!std::isfinite(value) || (value <= 0.0) != touch(image)) return false;
  if (shape_ == Shape::box) return is_nearest(box_gap(image), value);
  const Vector apart = difference(image);
  const mpq_class reach = number(sizes_[image.pair.first][0] + sizes_[image.pair.second][0]);
  // The distance to 64 bits behind the last place that the whole numbers have.
  const mpq_class distance = number(sqrt(dot(apart, apart) << 128)) >> 64;
  const mpq_class exact = distance - reach;
  if (abs(exact) >= largest) return std::fabs(value) >= largest * (1.0 - 0x1p-40);
  const mpq_class error = ((distance + reach) >> 48) + mpq_class(0x1p-1072);
  return abs(mpq_class(value) - exact) <= error;
}

}  // namespace abut::testing
