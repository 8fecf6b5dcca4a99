#pragma once

#include "exact/periodic_predicate.hpp"
#include "exact/rational_oracle.hpp"
#include "lattice/lattices.hpp"
#include "periodic/images.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <tuple>
#include <vector>

/// Small periodic systems searched pair by pair: through the images, and in rational numbers.
namespace abut::testing {

template <int Dim>
struct PeriodicSystem {
  std::vector<exact::Sphere<Dim>> spheres;
  exact::Lattice lattice;
  double margin = 0.0;
};

/// (i, j, n) of the contract: i < j, or i = j and n lexicographically positive.
struct FoundPair {
  std::size_t i;
  std::size_t j;
  ImageShift shift;

  friend auto operator<=>(const FoundPair&, const FoundPair&) = default;
  friend std::ostream& operator<<(std::ostream& out, const FoundPair& pair) {
    return out << '(' << pair.i << ", " << pair.j << ", " << pair.shift.x << ' ' << pair.shift.y
               << ' ' << pair.shift.z << ')';
  }
};

[[nodiscard]] inline FoundPair canonical(std::size_t i, std::size_t j, const ImageShift& n) {
  if (i > j || (i == j && n < ImageShift{})) return {j, i, {-n.x, -n.y, -n.z}};
  return {i, j, n};
}

/// How far from the origin elements may lie: near, some cells or many cells away. Where c has 2^20
/// a in it, shifts of those farther away would exceed 31 bits.
template <int Dim>
[[nodiscard]] double random_size(const NamedLattice<Dim>& lattice, Random& random) {
  const bool skewed = lattice.kind == std::string("skewed by many vectors");
  return std::array{1.0, 30.0, skewed ? 300.0 : 1e5}[random.below(3)];
}

/// x_i - (x_j + n A) on an axis, exactly.
template <int Dim>
[[nodiscard]] mpq_class exact_difference(double x_i, double x_j, const ImageShift& shift,
                                         const exact::Lattice& lattice, std::size_t axis) {
  mpq_class result = mpq_class(x_i) - mpq_class(x_j);
  for (std::size_t k = 0; k < Dim; ++k) {
    if (!lattice.periodic[k]) continue;
    result -= exact::numbers(shift)[k] * mpq_class(lattice.vectors[k][axis]);
  }
  return result;
}

template <int Dim>
[[nodiscard]] grid::Bounds<Dim> bounds_of(std::span<const exact::Sphere<Dim>> spheres) {
  grid::Bounds<Dim> bounds;
  for (const auto& sphere : spheres) {
    bounds.include_center(sphere);
    bounds.include_radius(sphere.radius);
  }
  return bounds;
}

template <int Dim>
void expect_same(const grid::Bounds<Dim>& a, const grid::Bounds<Dim>& b) {
  EXPECT_EQ(a.lower, b.lower);
  EXPECT_EQ(a.upper, b.upper);
  EXPECT_EQ(a.smallest_radius, b.smallest_radius);
  EXPECT_EQ(a.largest_radius, b.largest_radius);
  EXPECT_EQ(a.second_largest_radius, b.second_largest_radius);
}

template <int Dim>
[[nodiscard]] base::Array<exact::Sphere<Dim>> array_of(
    const std::vector<exact::Sphere<Dim>>& spheres, base::MemoryMeter& memory) {
  auto array = base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, spheres.size());
  std::copy(spheres.begin(), spheres.end(), array.begin());
  return array;
}

/// Whether two elements may be within reach of each other, as a search in open space sees it that
/// knows the slack.
template <int Dim>
[[nodiscard]] bool may_pair(const exact::Sphere<Dim>& a, const exact::Sphere<Dim>& b, double margin,
                            double slack) {
  double distance = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    distance = std::hypot(distance, a.center[axis] - b.center[axis]);
  }
  return distance <= (a.radius + b.radius + margin) * (1.0 + 0x1p-49) + slack;
}

/// Whether each has a coordinate beyond the box.
template <int Dim>
[[nodiscard]] bool are_outside(std::span<const exact::Sphere<Dim>> spheres,
                               const grid::Bounds<Dim>& box) {
  return std::all_of(spheres.begin(), spheres.end(), [&](const exact::Sphere<Dim>& sphere) {
    grid::Bounds<Dim> wider = box;
    wider.include_center(sphere);
    return wider.lower != box.lower || wider.upper != box.upper;
  });
}

/// The locals where ghosts stand behind them.
template <int Dim>
[[nodiscard]] std::span<const exact::Sphere<Dim>> packed_locals(
    const periodic::Images<Dim>& images) {
  return images.locals_and_ghosts().first(images.locals().size);
}

/// The locals, wherever they lie.
template <int Dim>
[[nodiscard]] std::vector<exact::Sphere<Dim>> locals_of(const periodic::Images<Dim>& images) {
  std::vector<exact::Sphere<Dim>> locals;
  for (std::size_t k = 0; k < images.locals().size; ++k) {
    locals.push_back(kernels::sphere_at<Dim>(images.locals(), k));
  }
  return locals;
}

template <int Dim>
void expect_right_bounds(const periodic::Images<Dim>& images) {
  const auto locals = locals_of(images);
  const auto ghosts = images.ghost_spheres();
  expect_same(images.local_bounds(), bounds_of<Dim>(locals));
  expect_same(images.ghost_bounds(), bounds_of<Dim>(ghosts));
  EXPECT_EQ(images.ghosts_are_outside(), are_outside<Dim>(ghosts, bounds_of<Dim>(locals)));
}

template <int Dim>
[[nodiscard]] std::vector<FoundPair> pairs_by_rationals(const PeriodicSystem<Dim>& system);

/// All that a search over locals and ghosts finds, in canonical order; a pair found twice stands
/// there twice. Of a long reach, which has no ghosts, it is what there is to find.
template <int Dim>
[[nodiscard]] std::vector<FoundPair> pairs_of(const periodic::Images<Dim>& images,
                                              const PeriodicSystem<Dim>& system) {
  if (images.reach_is_long()) return pairs_by_rationals(system);
  const double margin = system.margin * images.unit();
  const auto locals = locals_of(images);
  const auto ghosts = images.ghost_spheres();
  expect_right_bounds(images);
  std::vector<FoundPair> pairs;
  const auto decide = [&](std::size_t i, std::size_t j, const ImageShift& shift) {
    std::uint64_t exact_decisions = 0;
    const bool within = exact::within_reach(system.spheres[i], system.spheres[j], shift,
                                            system.lattice, system.margin, exact_decisions);
    if (within) pairs.push_back(canonical(i, j, shift));
  };
  for (std::size_t i = 0; i < locals.size(); ++i) {
    for (std::size_t j = i + 1; j < locals.size(); ++j) {
      if (!may_pair(locals[i], locals[j], margin, images.slack())) continue;
      decide(i, j, images.shift_between(i, j));
    }
    for (std::size_t g = 0; g < images.ghosts().size(); ++g) {
      if (!may_pair(locals[i], ghosts[g], margin, images.slack())) continue;
      const periodic::Ghost& ghost = images.ghosts()[g];
      if (images.counts(i, ghost)) decide(i, ghost.element, images.shift_between(i, ghost));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The pairs that are found by the images of packed spheres.
template <int Dim>
[[nodiscard]] std::vector<FoundPair> pairs_by_images(const PeriodicSystem<Dim>& system,
                                                     double size_cut = HUGE_VAL,
                                                     Simd simd = Simd::scalar) {
  const lattice::ReducedLattice<Dim> reduced(system.lattice);
  base::MemoryMeter memory;
  auto elements = array_of(system.spheres, memory);
  periodic::Images<Dim> images(memory);
  images.find(elements, bounds_of<Dim>(system.spheres), reduced,
              {system.margin, 1, kernels::image_kernels(simd), Shape::sphere, size_cut});
  return pairs_of(images, system);
}

/// The pairs that are found by the images of spheres that stay where they lie, and whether none of
/// these was moved.
template <int Dim>
struct PairsInPlace {
  std::vector<FoundPair> pairs;
  bool none_is_moved;

  PairsInPlace(const PeriodicSystem<Dim>& system, double size_cut, Simd simd) {
    const lattice::ReducedLattice<Dim> reduced(system.lattice);
    base::MemoryMeter memory;
    periodic::Images<Dim> images(memory);
    const auto given = kernels::strided_spheres<Dim>(system.spheres);
    images.find(given, bounds_of<Dim>(system.spheres), reduced,
                {system.margin, 1, kernels::image_kernels(simd), Shape::sphere, size_cut});
    // Elements whose shifts might not fit must be packed.
    pairs = images.shifts_always_fit() ? pairs_of(images, system) : pairs_by_rationals(system);
    none_is_moved = images.locals().begin[0] == given.begin[0];
  }
};

/// All images within reach, in rational numbers. The numbers m of the basis vectors are enumerated
/// within |f_k - m_k| <= reach / height_k, with exact fractional coordinates f and heights rounded
/// down: moving by the reach changes f_k by no more.
template <int Dim>
class RationalSearch {
 public:
  explicit RationalSearch(const PeriodicSystem<Dim>& system)
      : system_(system), reduced_(system.lattice) {
    invert_gram();
  }

  [[nodiscard]] std::vector<FoundPair> run() {
    for (std::size_t i = 0; i < system_.spheres.size(); ++i) {
      for (std::size_t j = i; j < system_.spheres.size(); ++j) search(i, j);
    }
    std::sort(pairs_.begin(), pairs_.end());
    return pairs_;
  }

 private:
  using Vector = std::array<mpq_class, Dim>;

  static mpq_class dot(const Vector& p, const Vector& q) {
    mpq_class sum = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) sum += p[axis] * q[axis];
    return sum;
  }

  void invert_gram() {
    mpq_class g[3][3];
    for (std::size_t k = 0; k < reduced_.count; ++k) {
      for (std::size_t l = 0; l < reduced_.count; ++l) {
        for (std::size_t axis = 0; axis < Dim; ++axis) {
          basis_[k][axis] += mpq_class(system_.lattice.vectors[reduced_.axis_of[l]][axis]) *
                             mpq_class(std::to_string(reduced_.to_given[k][l]));
        }
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t l = 0; l < 3; ++l) {
        const bool inside = k < reduced_.count && l < reduced_.count;
        g[k][l] = inside ? dot(basis_[k], basis_[l]) : mpq_class(k == l ? 1 : 0);
      }
    }
    const auto minor = [&](std::size_t r, std::size_t c) -> mpq_class {
      return g[(r + 1) % 3][(c + 1) % 3] * g[(r + 2) % 3][(c + 2) % 3] -
             g[(r + 1) % 3][(c + 2) % 3] * g[(r + 2) % 3][(c + 1) % 3];
    };
    const mpq_class determinant =
        g[0][0] * minor(0, 0) + g[0][1] * minor(0, 1) + g[0][2] * minor(0, 2);
    for (std::size_t k = 0; k < reduced_.count; ++k) {
      for (std::size_t l = 0; l < reduced_.count; ++l) {
        for (std::size_t axis = 0; axis < Dim; ++axis) {
          dual_[k][axis] += minor(l, k) / determinant * basis_[l][axis];
        }
      }
    }
  }

  void search(std::size_t i, std::size_t j) {
    const auto& a = system_.spheres[i];
    const auto& b = system_.spheres[j];
    const mpq_class reach = exact_reach(a, b, system_.margin);
    Vector apart;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      apart[axis] = mpq_class(a.center[axis]) - mpq_class(b.center[axis]);
    }
    mpz_class first[3], last[3];
    for (std::size_t k = 0; k < reduced_.count; ++k) {
      const mpq_class fraction = dot(dual_[k], apart);
      const mpq_class width = reach / mpq_class(reduced_.height[k]);
      const mpq_class low = fraction - width;
      const mpq_class high = fraction + width;
      mpz_cdiv_q(first[k].get_mpz_t(), low.get_num_mpz_t(), low.get_den_mpz_t());
      mpz_fdiv_q(last[k].get_mpz_t(), high.get_num_mpz_t(), high.get_den_mpz_t());
    }
    for (mpz_class x = first[0]; x <= last[0]; ++x) {
      for (mpz_class y = first[1]; y <= last[1]; ++y) {
        for (mpz_class z = first[2]; z <= last[2]; ++z) {
          decide(i, j, apart, reach, {x.get_si(), y.get_si(), z.get_si()});
        }
      }
    }
  }

  void decide(std::size_t i, std::size_t j, const Vector& apart, const mpq_class& reach,
              const lattice::ImageNumbers& image) {
    mpq_class square = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      mpq_class component = apart[axis];
      for (std::size_t k = 0; k < reduced_.count; ++k) {
        component -= mpq_class(std::to_string(image[k])) * basis_[k][axis];
      }
      square += component * component;
    }
    if (square > reach * reach) return;
    const ImageShift shift = reduced_.shift_of(image).value();
    if (i == j && shift <= ImageShift{}) return;
    pairs_.push_back({i, j, shift});
  }

  const PeriodicSystem<Dim>& system_;
  lattice::ReducedLattice<Dim> reduced_;
  std::array<Vector, 3> basis_;
  std::array<Vector, 3> dual_;
  std::vector<FoundPair> pairs_;
};

template <int Dim>
[[nodiscard]] std::vector<FoundPair> pairs_by_rationals(const PeriodicSystem<Dim>& system) {
  return RationalSearch<Dim>(system).run();
}

}  // namespace abut::testing
