#include "exact/simplices/hull_oracle.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using Row = std::vector<mpq_class>;

/// Weights w >= 0 with rows * w = their last numbers, none of which is negative: phase one, with an
/// artificial variable for each row. The last row is what these still add up to.
class WeightSearch {
 public:
  WeightSearch(std::vector<Row> rows, std::size_t weights)
      : rows_(std::move(rows)), weights_(weights), objective_(weights + 1) {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      basis_.push_back(weights + k);
      for (std::size_t j = 0; j <= weights; ++j) objective_[j] += rows_[k][j];
    }
  }

  [[nodiscard]] bool succeeds() {
    for (std::size_t entering = next(); entering < weights_; entering = next()) {
      pivot(leaving(entering), entering);
    }
    return objective_.back() == 0;
  }

 private:
  [[nodiscard]] std::size_t next() const {
    std::size_t j = 0;
    while (j < weights_ && objective_[j] <= 0) ++j;
    return j;
  }

  [[nodiscard]] std::size_t leaving(std::size_t entering) const {
    std::size_t best = rows_.size();
    mpq_class least;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (rows_[k][entering] <= 0) continue;
      const mpq_class ratio = rows_[k].back() / rows_[k][entering];
      if (best == rows_.size() || ratio < least || (ratio == least && basis_[k] < basis_[best])) {
        best = k;
        least = ratio;
      }
    }
    return best;
  }

  void pivot(std::size_t row, std::size_t entering) {
    const mpq_class divisor = rows_[row][entering];
    for (mpq_class& number : rows_[row]) number /= divisor;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (k != row) subtract(rows_[k], rows_[row], entering);
    }
    subtract(objective_, rows_[row], entering);
    basis_[row] = entering;
  }

  static void subtract(Row& from, const Row& row, std::size_t entering) {
    const mpq_class factor = from[entering];
    if (factor == 0) return;
    for (std::size_t j = 0; j < row.size(); ++j) from[j] -= factor * row[j];
  }

  std::vector<Row> rows_;
  std::size_t weights_;
  Row objective_;
  std::vector<std::size_t> basis_;
};

}  // namespace

template <int Dim>
bool hulls_meet_by_rationals(const exact::Simplex<Dim>& a, const exact::Simplex<Dim>& b) {
  return hulls_meet_by_rationals(a, b, {}, {});
}

/// The weights of either set add up to 1, and along each axis both means are the same.
template <int Dim>
bool hulls_meet_by_rationals(const exact::Simplex<Dim>& a, const exact::Simplex<Dim>& b,
                             const ImageShift& shift, const exact::Lattice& lattice) {
  const std::size_t weights = a.size + b.size;
  std::vector<Row> rows(Dim + 2, Row(weights + 1));
  rows[0].back() = rows[1].back() = 1;
  for (std::size_t k = 0; k < weights; ++k) {
    const bool of_a = k < a.size;
    rows[of_a ? 0 : 1][k] = 1;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      mpq_class& number = rows[axis + 2][k];
      if (of_a) {
        number = mpq_class(a.vertices[k][axis]);
        continue;
      }
      number = mpq_class(-b.vertices[k - a.size][axis]);
      for (std::size_t vector = 0; vector < Dim; ++vector) {
        if (!lattice.periodic[vector]) continue;
        number -=
            mpq_class(exact::numbers(shift)[vector]) * mpq_class(lattice.vectors[vector][axis]);
      }
    }
  }
  return WeightSearch(std::move(rows), weights).succeeds();
}

template bool hulls_meet_by_rationals(const exact::Simplex<2>&, const exact::Simplex<2>&);
template bool hulls_meet_by_rationals(const exact::Simplex<3>&, const exact::Simplex<3>&);
template bool hulls_meet_by_rationals(const exact::Simplex<2>&, const exact::Simplex<2>&,
                                      const ImageShift&, const exact::Lattice&);
template bool hulls_meet_by_rationals(const exact::Simplex<3>&, const exact::Simplex<3>&,
                                      const ImageShift&, const exact::Lattice&);

}  // namespace abut::testing
