#pragma once

#include "support/periodic_oracle.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// The contract in whole numbers, for any finite input and any lattice: all numbers of a system
/// over one power of two. It shares nothing with the library.
namespace abut::testing {

/// Elements as plain arrays, by axis; in 2D the third is empty.
struct ElementArrays {
  int dimensions = 3;
  Shape shape = Shape::sphere;
  std::array<std::vector<double>, 3> lower;  ///< centers of spheres
  std::array<std::vector<double>, 3> upper;  ///< of boxes
  std::vector<double> radius;                ///< of spheres

  [[nodiscard]] std::size_t size() const noexcept { return lower[0].size(); }
};

/// The elements of `first`, then those of `second`.
[[nodiscard]] ElementArrays joined(const ElementArrays& first, const ElementArrays& second);

struct OracleAnswer {
  std::vector<ImagePair> pairs;  ///< in canonical order
  /// More images within reach than were asked for, or boxes far wider than the cell, along whatever
  /// axis, of which the library looks at as many images: no answer.
  bool too_many = false;
  bool beyond_shifts = false;  ///< some pair has a shift beyond 32 bits; it is left out
  /// Elements or their reach may extend over more than 2^20 lattice vectors, a short basis needs as
  /// many of a vector, or some vector is nearly 2^450 times shorter than the longest one given.
  bool far = false;
};

class ExactOracle {
 public:
  ExactOracle(const ElementArrays& elements, const Domain& domain, double margin);

  /// All contact pairs of one set, unless there are more than `most`.
  [[nodiscard]] OracleAnswer pairs(std::uint64_t most) const;

  /// Whether two elements touch, the margin left aside.
  [[nodiscard]] bool touch(const ImagePair& image) const;

  /// Whether it is x_i - (x_j + n A) on an axis, rounded once, to even.
  [[nodiscard]] bool is_component(const ImagePair& image, std::size_t axis, double value) const;

  /// Whether it is the nearest double to the distance, the smaller of two; below 2^-1000 one of the
  /// nearest three.
  [[nodiscard]] bool is_distance(const ImagePair& image, double value) const;

  /// Whether it is, of spheres, the unit vector from i to j (from x_i to x_j + n A), each component
  /// off by at most one unit in the last place of the largest; 0 where centers coincide.
  [[nodiscard]] bool is_normal(const ImagePair& image, const std::array<double, 3>& value) const;

  /// Whether it is, of spheres, the middle between the surfaces on the line of centers, each
  /// component off by at most one unit in the last place of the largest, or 2^-94 of the largest
  /// number of the two elements.
  [[nodiscard]] bool is_point(const ImagePair& image, const std::array<double, 3>& value) const;

  /// Whether it is the gap: of boxes rounded once; of spheres with the right sign, and off by at
  /// most 2^-48 of the distance and the radii, and 2^-1072.
  [[nodiscard]] bool is_gap(const ImagePair& image, double value) const;

 private:
  using Vector = std::array<mpz_class, 3>;
  struct Search;

  /// A vector of the reduced lattice, and what bounds its multiples.
  struct Level {
    Vector vector;
    std::array<mpz_class, 3> steps;  ///< in vectors of the domain
    Vector functional;               ///< orthogonal to the vectors of lower levels
    mpz_class determinant;           ///< functional . vector
    mpz_class bound;                 ///< functional . functional
  };

  /// A length to 128 bits behind the last place that the whole numbers have.
  [[nodiscard]] static mpq_class length(const Vector& vector);
  [[nodiscard]] static mpz_class dot(const Vector& a, const Vector& b);
  [[nodiscard]] mpz_class whole(double value) const;
  void read_elements(const ElementArrays& elements, double margin);
  void read_lattice(const Domain& domain);
  void reduce_lattice();
  void make_functionals();
  [[nodiscard]] bool is_far() const;
  [[nodiscard]] bool is_unequal() const;
  [[nodiscard]] bool has_wide_boxes() const;
  [[nodiscard]] Vector difference(const ImagePair& image) const;
  [[nodiscard]] mpq_class number(const mpz_class& whole) const;
  [[nodiscard]] mpq_class box_gap(const ImagePair& image) const;

  int dimensions_ = 3;
  Shape shape_ = Shape::sphere;
  int exponent_ = 0;  ///< whole numbers times 2^exponent are the numbers given
  std::vector<Vector> centers_;
  std::vector<Vector> sizes_;  ///< half of the sides of boxes; of spheres the radius, first
  mpz_class margin_;
  std::array<bool, 3> periodic_{};
  std::array<Vector, 3> lattice_;  ///< as given
  std::vector<Level> levels_;      ///< shortest vector first
};

}  // namespace abut::testing
