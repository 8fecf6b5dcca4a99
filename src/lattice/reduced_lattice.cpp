// Reduction after H. Minkowski; in three dimensions by I. Semaev (A 3-dimensional lattice reduction
// algorithm, Cryptography and Lattices, 2001, 181-193): the longest vector is shortened by the
// nearest combination of the others, until none becomes shorter. Doubles only propose; what is
// taken from what is kept in integers, and each vector is the exact combination, rounded once.

#include "lattice/reduced_lattice.hpp"

#include "exact/numbers/bits.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "lattice/check_lattice.hpp"
#include "lattice/dot.hpp"
#include "lattice/rounding_factors.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <utility>

namespace abut::lattice {
namespace {

/// A vector counts as shorter only if its square is by this factor: there are finitely many that
/// are, so that the reduction ends.
constexpr double shorter = 1.0 - 0x1p-20;

/// Squares of shorter vectors, beside a largest component between 1/2 and 1, would lose bits.
constexpr double least_square = 0x1p-900;

using exact::Int128;

[[noreturn]] void refuse_shape() {
  throw Error(ErrorCode::invalid_input,
              "the lattice vectors are so skewed that a short basis exceeds the range of numbers; "
              "give vectors of the same lattice that are shorter");
}

[[noreturn]] void refuse_ratio() {
  throw Error(ErrorCode::invalid_input,
              "the lattice has a vector that is shorter than 2^-450 of the longest one given; give "
              "vectors of more equal lengths, or make the axis of the long one open");
}

std::int64_t narrowed(Int128 value) {
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  if (value > largest || value < -Int128{largest}) refuse_shape();
  return static_cast<std::int64_t>(value);
}

template <int Dim>
double largest_component(std::span<const std::array<double, Dim>> vectors) {
  double largest = 0.0;
  for (const auto& vector : vectors) {
    for (const double x : vector) largest = std::max(largest, std::fabs(x));
  }
  return largest;
}

/// Times a power of two, whatever the exponents.
template <int Dim>
std::array<double, Dim> scaled(std::array<double, Dim> vector, int exponent) {
  for (double& x : vector) x = std::ldexp(x, exponent);
  return vector;
}

/// A basis of the lattice on its way to the shortest.
template <int Dim>
class Reduction {
 public:
  using Vector = std::array<double, Dim>;

  explicit Reduction(std::span<const Vector> given) : given_(given) {
    exponent_ = -std::ilogb(largest_component<Dim>(given)) - 1;
    for (std::size_t k = 0; k < given.size(); ++k) {
      to_given[k][k] = from_given[k][k] = 1;
      set(k, to_given[k]);
    }
  }

  void run() {
    while (shorten_one()) {
    }
  }

  /// Returns the sum of `numbers` of the given vectors, rounded once; `remainder` is what is left.
  [[nodiscard]] Vector combined(const ImageNumbers& numbers, Vector* remainder = nullptr) const {
    Vector result{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      exact::ExactAccumulator<1> sum;
      for (std::size_t l = 0; l < given_.size(); ++l) sum.add(given_[l][axis], numbers[l]);
      result[axis] = sum.rounded();
      if (remainder == nullptr) continue;
      sum.add(result[axis], -1);
      (*remainder)[axis] = sum.rounded();
    }
    return result;
  }

  std::array<ImageNumbers, 3> to_given{};
  std::array<ImageNumbers, 3> from_given{};

 private:
  void set(std::size_t k, const ImageNumbers& numbers) {
    to_given[k] = numbers;
    vectors_[k] = scaled<Dim>(combined(numbers), exponent_);
    squares_[k] = dot<Dim>(vectors_[k], vectors_[k]);
    if (!(squares_[k] >= least_square)) refuse_ratio();
  }

  /// Tries the shorter vectors first; false when nothing can be shortened.
  bool shorten_one() {
    std::array<std::size_t, 3> order{0, 1, 2};
    // Three numbers by insertion: std::stable_sort would allocate.
    for (std::size_t end = 1; end < given_.size(); ++end) {
      for (std::size_t k = end; k > 0 && squares_[order[k]] < squares_[order[k - 1]]; --k) {
        std::swap(order[k], order[k - 1]);
      }
    }
    for (std::size_t rank = 1; rank < given_.size(); ++rank) {
      if (shorten(order[rank], std::span(order).first(rank))) return true;
    }
    return false;
  }

  /// Takes from vector k the combination of the others, one or two, that leaves least.
  bool shorten(std::size_t k, std::span<const std::size_t> others) {
    const std::array<double, 2> nearest = projection(k, others);
    std::array<std::int64_t, 2> best{};
    double best_square = squares_[k] * shorter;
    bool found = false;
    const double reach_of_second = others.size() == 2 ? 1.0 : 0.0;
    for (double first = -1.0; first <= 1.0; first += 1.0) {
      for (double second = -reach_of_second; second <= reach_of_second; second += 1.0) {
        const std::array<std::int64_t, 2> taken{whole(nearest[0] + first),
                                                whole(nearest[1] + second)};
        if (is_clearly_longer(k, others, taken)) continue;
        const Vector left = scaled<Dim>(combined(without(k, others, taken)), exponent_);
        const double square = dot<Dim>(left, left);
        if (!(square < best_square)) continue;
        best_square = square;
        best = taken;
        found = true;
      }
    }
    if (found) take(k, others, best);
    return found;
  }

  /// Decides in doubles if few vectors are taken; exact combinations take microseconds.
  [[nodiscard]] bool is_clearly_longer(std::size_t k, std::span<const std::size_t> others,
                                       const std::array<std::int64_t, 2>& taken) const {
    Vector left = vectors_[k];
    for (std::size_t o = 0; o < others.size(); ++o) {
      if (std::abs(taken[o]) > 1) return false;
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        left[axis] -= static_cast<double>(taken[o]) * vectors_[others[o]][axis];
      }
    }
    return dot<Dim>(left, left) >= squares_[k];
  }

  /// Integers nearest to the coefficients of vector k's projection on one or two others.
  [[nodiscard]] std::array<double, 2> projection(std::size_t k,
                                                 std::span<const std::size_t> others) const {
    const Vector& v = vectors_[k];
    const Vector& p = vectors_[others[0]];
    if (others.size() == 1) return {std::nearbyint(dot<Dim>(v, p) / squares_[others[0]]), 0.0};
    // The others are reduced: at 60 degrees or more, so that Cramer's rule is accurate. Their
    // lengths may differ, hence the coefficients relative to the lengths.
    const Vector& q = vectors_[others[1]];
    const double p_length = std::sqrt(squares_[others[0]]);
    const double q_length = std::sqrt(squares_[others[1]]);
    const double cosine = dot<Dim>(p, q) / p_length / q_length;
    const double along_p = dot<Dim>(v, p) / p_length;
    const double along_q = dot<Dim>(v, q) / q_length;
    const double square_of_sine = 1.0 - cosine * cosine;
    return {std::nearbyint((along_p - cosine * along_q) / square_of_sine / p_length),
            std::nearbyint((along_q - cosine * along_p) / square_of_sine / q_length)};
  }

  static std::int64_t whole(double number) {
    if (!(std::fabs(number) <= 0x1p62)) refuse_shape();
    return static_cast<std::int64_t>(number);
  }

  [[nodiscard]] ImageNumbers without(std::size_t k, std::span<const std::size_t> others,
                                     const std::array<std::int64_t, 2>& taken) const {
    ImageNumbers numbers{};
    for (std::size_t l = 0; l < 3; ++l) {
      Int128 left = to_given[k][l];
      for (std::size_t o = 0; o < others.size(); ++o) {
        left = narrowed(left - Int128{taken[o]} * to_given[others[o]][l]);
      }
      numbers[l] = narrowed(left);
    }
    return numbers;
  }

  void take(std::size_t k, std::span<const std::size_t> others,
            const std::array<std::int64_t, 2>& taken) {
    set(k, without(k, others, taken));
    // A in terms of b: what was taken from b_k comes back in the columns of the others.
    for (ImageNumbers& row : from_given) {
      for (std::size_t o = 0; o < others.size(); ++o) {
        row[others[o]] = narrowed(row[others[o]] + Int128{taken[o]} * row[k]);
      }
    }
  }

  std::span<const Vector> given_;
  std::array<Vector, 3> vectors_{};  ///< times 2^exponent_
  std::array<double, 3> squares_{};
  int exponent_ = 0;
};

/// The inverse of a symmetric matrix of one to three rows, by the adjugate.
std::array<std::array<double, 3>, 3> inverse_of_gram(const std::array<std::array<double, 3>, 3>& g,
                                                     std::size_t count) {
  std::array<std::array<double, 3>, 3> padded = g;
  for (std::size_t k = count; k < 3; ++k) padded[k][k] = 1.0;
  const auto minor = [&](std::size_t row, std::size_t column) {
    const std::size_t r = (row + 1) % 3, s = (row + 2) % 3;
    const std::size_t c = (column + 1) % 3, d = (column + 2) % 3;
    return padded[r][c] * padded[s][d] - padded[r][d] * padded[s][c];
  };
  const double determinant =
      padded[0][0] * minor(0, 0) + padded[0][1] * minor(0, 1) + padded[0][2] * minor(0, 2);
  std::array<std::array<double, 3>, 3> inverse{};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) inverse[i][j] = minor(j, i) / determinant;
  }
  return inverse;
}

/// Dual vectors and all that follows from them. The Gram matrix of unit vectors along a reduced
/// basis has a determinant of at least 1/2, so that its inverse is accurate.
template <int Dim>
void derive_dual(ReducedLattice<Dim>& lattice, int exponent) {
  using Vector = std::array<double, Dim>;
  std::array<Vector, 3> unit{};
  std::array<double, 3> length{};
  for (std::size_t k = 0; k < lattice.count; ++k) {
    unit[k] = scaled<Dim>(lattice.vectors[k], exponent);
    length[k] = std::sqrt(dot<Dim>(unit[k], unit[k]));
    for (double& x : unit[k]) x /= length[k];
  }
  std::array<std::array<double, 3>, 3> gram{};
  for (std::size_t i = 0; i < lattice.count; ++i) {
    for (std::size_t j = 0; j < lattice.count; ++j) gram[i][j] = dot<Dim>(unit[i], unit[j]);
  }
  const auto inverse = inverse_of_gram(gram, lattice.count);
  for (std::size_t k = 0; k < lattice.count; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      double sum = 0.0;
      for (std::size_t l = 0; l < lattice.count; ++l) sum += inverse[k][l] * unit[l][axis];
      lattice.dual[k][axis] = sum / length[k];
    }
    const double dual_length = std::sqrt(dot<Dim>(lattice.dual[k], lattice.dual[k]));
    lattice.dual_length[k] = dual_length * up;
    lattice.length[k] = std::ldexp(length[k] * up, -exponent);
    lattice.height[k] = std::nextafter(std::ldexp(down / dual_length, -exponent), 0.0);
  }
}

/// Checks what docs/derivations/periodic_images.md assumes of the dual vectors: dual_k . b_l is 1
/// or 0 but for 2^-46 of the lengths, and no b is more than twice as long as its height.
template <int Dim>
bool is_sound(const ReducedLattice<Dim>& lattice, int exponent) {
  for (std::size_t k = 0; k < lattice.count; ++k) {
    for (std::size_t l = 0; l < lattice.count; ++l) {
      const auto vector = scaled<Dim>(lattice.vectors[l], exponent);
      const double product = lattice.dual_length[k] * std::sqrt(dot<Dim>(vector, vector));
      const double error = dot<Dim>(lattice.dual[k], vector) - (k == l ? 1.0 : 0.0);
      if (!(std::fabs(error) <= 0x1p-46 * product)) return false;
      if (k == l && !(product <= 2.0)) return false;
    }
  }
  return true;
}

}  // namespace

template <int Dim>
ReducedLattice<Dim>::ReducedLattice(const exact::Lattice& given) {
  check_lattice<Dim>(given);
  std::array<Vector, Dim> periodic{};
  for (std::size_t k = 0; k < Dim; ++k) {
    if (!given.periodic[k]) continue;
    std::copy_n(given.vectors[k].begin(), Dim, periodic[count].begin());
    axis_of[count++] = k;
  }
  if (count == 0) return;

  Reduction<Dim> reduction(std::span<const Vector>(periodic).first(count));
  reduction.run();
  to_given = reduction.to_given;
  from_given = reduction.from_given;
  for (std::size_t k = 0; k < count; ++k) {
    vectors[k] = reduction.combined(to_given[k], &remainders[k]);
  }
  const std::span<const Vector> basis = std::span<const Vector>(vectors).first(count);
  // Within what a normal number can be, together with its inverse.
  const int exponent = std::clamp(-std::ilogb(largest_component<Dim>(basis)) - 2, -1000, 1000);
  scale = std::ldexp(1.0, exponent);
  derive_dual(*this, exponent);
  if (!is_sound(*this, exponent)) refuse_shape();
}

template <int Dim>
void ReducedLattice<Dim>::turn(std::size_t k) noexcept {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    vectors[k][axis] = -vectors[k][axis];
    remainders[k][axis] = -remainders[k][axis];
    dual[k][axis] = -dual[k][axis];
  }
  for (std::size_t l = 0; l < count; ++l) {
    to_given[k][l] = -to_given[k][l];
    from_given[l][k] = -from_given[l][k];
  }
}

template <int Dim>
exact::FarShift ReducedLattice<Dim>::far_shift_of(const ImageNumbers& numbers) const noexcept {
  exact::FarShift shift{};
  for (std::size_t l = 0; l < count; ++l) {
    for (std::size_t k = 0; k < count; ++k) {
      shift[axis_of[l]] += Int128{numbers[k]} * to_given[k][l];
    }
  }
  return shift;
}

template <int Dim>
std::optional<ImageShift> ReducedLattice<Dim>::shift_of(
    const ImageNumbers& numbers) const noexcept {
  constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max();
  const exact::FarShift far = far_shift_of(numbers);
  std::array<std::int32_t, 3> shift{};
  for (std::size_t l = 0; l < 3; ++l) {
    if (far[l] > largest || far[l] < -Int128{largest}) return std::nullopt;
    shift[l] = static_cast<std::int32_t>(far[l]);
  }
  return ImageShift{shift[0], shift[1], shift[2]};
}

template struct ReducedLattice<2>;
template struct ReducedLattice<3>;

}  // namespace abut::lattice
