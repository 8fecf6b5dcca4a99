#include "support/exact_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut::testing {
namespace {

using Vector = std::array<mpz_class, 3>;

/// A finite number as significand 2^exponent, the significand odd, or 0.
struct Decomposed {
  std::int64_t significand = 0;
  int exponent = 0;
};

Decomposed decompose(double value) {
  if (value == 0.0) return {};
  int exponent = 0;
  auto significand = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  for (; significand % 2 == 0; significand /= 2) ++exponent;
  return {significand, exponent};
}

// Numbers are changed in place: temporary ones would take most of the time.

void set_to_dot(mpz_class& result, const Vector& a, const Vector& b) {
  mpz_mul(result.get_mpz_t(), a[0].get_mpz_t(), b[0].get_mpz_t());
  mpz_addmul(result.get_mpz_t(), a[1].get_mpz_t(), b[1].get_mpz_t());
  mpz_addmul(result.get_mpz_t(), a[2].get_mpz_t(), b[2].get_mpz_t());
}

void subtract(Vector& from, const mpz_class& times, const Vector& vector) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    mpz_submul(from[axis].get_mpz_t(), times.get_mpz_t(), vector[axis].get_mpz_t());
  }
}

mpz_class floor_of_quotient(const mpz_class& a, const mpz_class& b) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  return result;
}

long bits(const mpz_class& value) {
  return value == 0 ? 0 : static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

}  // namespace

ElementArrays joined(const ElementArrays& first, const ElementArrays& second) {
  ElementArrays both = first;
  const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    append(both.lower[axis], second.lower[axis]);
    append(both.upper[axis], second.upper[axis]);
  }
  append(both.radius, second.radius);
  return both;
}

mpz_class ExactOracle::dot(const Vector& a, const Vector& b) {
  mpz_class result;
  set_to_dot(result, a, b);
  return result;
}

ExactOracle::ExactOracle(const ElementArrays& elements, const Domain& domain, double margin)
    : dimensions_(elements.dimensions), shape_(elements.shape) {
  int smallest = 1024;
  const auto look_at = [&](double value) {
    if (value != 0.0) smallest = std::min(smallest, decompose(value).exponent);
  };
  for (const auto* columns : {&elements.lower, &elements.upper}) {
    for (const std::vector<double>& column : *columns) std::ranges::for_each(column, look_at);
  }
  std::ranges::for_each(elements.radius, look_at);
  look_at(margin);
  for (int k = 0; k < 3; ++k) std::ranges::for_each(domain.vector(k), look_at);
  exponent_ = smallest - 1;  // centers of boxes are halves
  read_elements(elements, margin);
  read_lattice(domain);
  reduce_lattice();
  make_functionals();
}

mpz_class ExactOracle::whole(double value) const {
  const Decomposed parts = decompose(value);
  mpz_class result(static_cast<long>(parts.significand));
  if (parts.significand == 0) return result;
  mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(),
               static_cast<mp_bitcnt_t>(parts.exponent - exponent_));
  return result;
}

void ExactOracle::read_elements(const ElementArrays& elements, double margin) {
  centers_.resize(elements.size());
  sizes_.resize(elements.size());
  margin_ = whole(margin);
  const auto axes = static_cast<std::size_t>(dimensions_);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (shape_ == Shape::sphere) sizes_[k][0] = whole(elements.radius[k]);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      centers_[k][axis] = whole(elements.lower[axis][k]);
      if (shape_ == Shape::sphere) continue;
      const mpz_class upper = whole(elements.upper[axis][k]);
      sizes_[k][axis] = (upper - centers_[k][axis]) / 2;
      centers_[k][axis] = (upper + centers_[k][axis]) / 2;
    }
  }
}

void ExactOracle::read_lattice(const Domain& domain) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimensions_); ++k) {
    periodic_[k] = domain.is_periodic(static_cast<int>(k));
    if (!periodic_[k]) continue;
    Level level;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions_); ++axis) {
      level.vector[axis] = whole(domain.vector(static_cast<int>(k))[axis]);
    }
    level.steps[k] = 1;
    lattice_[k] = level.vector;
    levels_.push_back(level);
  }
}

/// Takes multiples of one vector from another as long as that makes it shorter.
void ExactOracle::reduce_lattice() {
  bool changed = true;
  while (changed) {
    changed = false;
    for (Level& level : levels_) {
      for (const Level& other : levels_) {
        if (&level == &other) continue;
        const mpz_class square = dot(other.vector, other.vector);
        const mpz_class product = dot(level.vector, other.vector);
        if (2 * abs(product) <= square) continue;
        const mpz_class times = floor_of_quotient(2 * product + square, 2 * square);
        subtract(level.vector, times, other.vector);
        subtract(level.steps, times, other.steps);
        changed = true;
      }
    }
  }
  std::ranges::sort(levels_, [](const Level& a, const Level& b) {
    return dot(a.vector, a.vector) < dot(b.vector, b.vector);
  });
}

/// By Cramer's rule, so that all remains whole: the functional of a level is the part of its vector
/// that is orthogonal to those below, times the determinant of these.
void ExactOracle::make_functionals() {
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    Level& level = levels_[k];
    if (k == 0) {
      level.functional = level.vector;
    } else if (k == 1) {
      const Vector& a = levels_[0].vector;
      level.functional = {};
      subtract(level.functional, -dot(a, a), level.vector);
      subtract(level.functional, dot(a, level.vector), a);
    } else {
      const Vector& a = levels_[0].vector;
      const Vector& b = levels_[1].vector;
      const mpz_class aa = dot(a, a), ab = dot(a, b), bb = dot(b, b);
      const mpz_class ac = dot(a, level.vector), bc = dot(b, level.vector);
      level.functional = {};
      subtract(level.functional, ab * ab - aa * bb, level.vector);
      subtract(level.functional, ac * bb - bc * ab, a);
      subtract(level.functional, bc * aa - ac * ab, b);
    }
    level.determinant = dot(level.functional, level.vector);
    level.bound = dot(level.functional, level.functional);
  }
}

/// Goes through the multiples of the vectors, the longest first.
struct ExactOracle::Search {
  const ExactOracle& oracle;
  std::uint64_t most;
  OracleAnswer& answer;
  std::size_t i = 0, j = 0;
  Vector reach{};  ///< of spheres the first
  mpz_class reach_squared{};
  std::array<mpz_class, 3> multiples{};
  std::array<mpz_class, 3> last_multiples{};
  std::array<mpz_class, 3> most_values{};  ///< the largest of each level's functional within reach
  std::array<Vector, 4> differences{};     ///< left above each level
  mpz_class scratch{};
  std::uint64_t looked_at = 0;  ///< images, most of which may be out of reach

  void begin(std::size_t first, std::size_t second) {
    i = first;
    j = second;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      reach[axis] = oracle.sizes_[i][axis] + oracle.sizes_[j][axis] + oracle.margin_;
    }
    reach_squared = reach[0] * reach[0];
    const std::size_t height = oracle.levels_.size();
    for (std::size_t k = 0; k < height; ++k) most_values[k] = extent(oracle.levels_[k]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      differences[height][axis] = oracle.centers_[i][axis] - oracle.centers_[j][axis];
    }
    descend(height);
  }

  [[nodiscard]] bool within_reach(const Vector& difference) {
    if (oracle.shape_ == Shape::sphere) {
      set_to_dot(scratch, difference, difference);
      return scratch <= reach_squared;
    }
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(oracle.dimensions_); ++axis) {
      if (mpz_cmpabs(difference[axis].get_mpz_t(), reach[axis].get_mpz_t()) > 0) return false;
    }
    return true;
  }

  /// The largest value of a functional on what is within reach of the origin.
  [[nodiscard]] mpz_class extent(const Level& level) const {
    if (oracle.shape_ == Shape::sphere) return sqrt(reach_squared * level.bound);
    mpz_class sum = 0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(oracle.dimensions_); ++axis) {
      sum += abs(level.functional[axis]) * reach[axis];
    }
    return sum;
  }

  /// The multiples of a level's vector that may be within reach of what is left above it. False
  /// where there are too many.
  [[nodiscard]] bool find_multiples(std::size_t k) {
    const Level& level = oracle.levels_[k];
    mpz_class& first = multiples[k];
    mpz_class& last = last_multiples[k];
    set_to_dot(scratch, level.functional, differences[k + 1]);
    first = scratch - most_values[k];
    mpz_cdiv_q(first.get_mpz_t(), first.get_mpz_t(), level.determinant.get_mpz_t());
    last = scratch + most_values[k];
    mpz_fdiv_q(last.get_mpz_t(), last.get_mpz_t(), level.determinant.get_mpz_t());
    scratch = last - first;
    return scratch <= static_cast<unsigned long>(most);
  }

  void descend(std::size_t height) {
    if (answer.too_many) return;
    if (height == 0) {
      if (++looked_at > 64 * most) answer.too_many = true;
      if (within_reach(differences[0])) record();
      return;
    }
    const std::size_t k = height - 1;
    if (!find_multiples(k)) {
      answer.too_many = true;
      return;
    }
    differences[k] = differences[height];
    subtract(differences[k], multiples[k], oracle.levels_[k].vector);
    for (; multiples[k] <= last_multiples[k]; ++multiples[k]) {
      descend(k);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        differences[k][axis] -= oracle.levels_[k].vector[axis];
      }
    }
  }

  void record() {
    std::array<mpz_class, 3> n{};
    for (std::size_t k = 0; k < oracle.levels_.size(); ++k) {
      subtract(n, -multiples[k], oracle.levels_[k].steps);
    }
    if (i == j && n <= std::array<mpz_class, 3>{}) return;
    if (answer.pairs.size() >= most) {
      answer.too_many = true;
      return;
    }
    constexpr long most_cells = 2147483647;
    if (std::ranges::any_of(n, [](const mpz_class& x) { return abs(x) > most_cells; })) {
      answer.beyond_shifts = true;
      return;
    }
    const auto narrow = [](const mpz_class& x) { return static_cast<std::int32_t>(x.get_si()); };
    answer.pairs.push_back({{static_cast<ElementIndex>(i), static_cast<ElementIndex>(j)},
                            {narrow(n[0]), narrow(n[1]), narrow(n[2])}});
  }
};

OracleAnswer ExactOracle::pairs(std::uint64_t most) const {
  OracleAnswer answer;
  if (has_wide_boxes()) {
    answer.too_many = true;
    return answer;
  }
  answer.far = is_far();
  Search search{*this, most, answer};
  for (std::size_t i = 0; i < centers_.size() && !answer.too_many; ++i) {
    for (std::size_t j = levels_.empty() ? i + 1 : i; j < centers_.size(); ++j) search.begin(i, j);
  }
  std::ranges::sort(answer.pairs);
  return answer;
}

bool ExactOracle::is_unequal() const {
  long square_bits = 0;
  for (const Vector& vector : lattice_)
    square_bits = std::max(square_bits, bits(dot(vector, vector)));
  return !levels_.empty() &&
         square_bits - bits(dot(levels_[0].vector, levels_[0].vector)) > 2 * 448;
}

bool ExactOracle::has_wide_boxes() const {
  long side_bits = 0;
  for (const Vector& sizes : sizes_) {
    for (const mpz_class& x : sizes) side_bits = std::max(side_bits, bits(x) + 1);
  }
  return shape_ == Shape::box && std::ranges::any_of(levels_, [&](const Level& level) {
           return side_bits - (bits(level.determinant) - bits(level.bound) / 2) > 5;
         });
}

bool ExactOracle::is_far() const {
  if (is_unequal()) return true;
  long coordinate_bits = bits(margin_);
  for (const auto* vectors : {&centers_, &sizes_}) {
    for (const Vector& vector : *vectors) {
      for (const mpz_class& x : vector) coordinate_bits = std::max(coordinate_bits, bits(x));
    }
  }
  // |b*|^2 = determinant^2 / bound.
  for (const Level& level : levels_) {
    long step_bits = 0;
    for (const mpz_class& step : level.steps) step_bits = std::max(step_bits, bits(step));
    const long height_bits = bits(level.determinant) - bits(level.bound) / 2;
    if (step_bits > 20 || coordinate_bits + step_bits - height_bits > 20) return true;
  }
  return false;
}

ExactOracle::Vector ExactOracle::difference(const ImagePair& image) const {
  Vector result = centers_[image.pair.first];
  subtract(result, 1, centers_[image.pair.second]);
  subtract(result, image.shift.x, lattice_[0]);
  subtract(result, image.shift.y, lattice_[1]);
  subtract(result, image.shift.z, lattice_[2]);
  return result;
}

}  // namespace abut::testing
