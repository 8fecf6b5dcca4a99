// Contacts of simplices in periodic domains, beside all images in rational numbers.

#include "elements/lattice_of.hpp"
#include "exact/simplices/hull_oracle.hpp"
#include "simplices/simplex_systems.hpp"
#include "support/error_expectations.hpp"

#include <abut/simplex_contacts.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace abut::testing {
namespace {

using Contact = std::tuple<ElementIndex, ElementIndex, std::int32_t, std::int32_t, std::int32_t>;

template <std::size_t Dim, class System>
exact::Simplex<Dim> simplex_of(const System& system, std::size_t number) {
  exact::Simplex<Dim> simplex{};
  for (const auto vertex : system.cells[number]) {
    const auto& position = system.vertices[static_cast<std::size_t>(vertex)];
    std::copy(position.begin(), position.end(), simplex.vertices[simplex.size++].begin());
  }
  return simplex;
}

template <class CellA, class CellB>
bool share_vertex(const CellA& a, const CellB& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](auto number) { return std::find(b.begin(), b.end(), number) != b.end(); });
}

/// All shifts of at most two cells along each axis that is periodic.
std::vector<ImageShift> shifts_of(const Domain& domain) {
  std::vector<ImageShift> shifts;
  const auto most = [&](int axis) { return domain.is_periodic(axis) ? 2 : 0; };
  for (std::int32_t x = -most(0); x <= most(0); ++x) {
    for (std::int32_t y = -most(1); y <= most(1); ++y) {
      for (std::int32_t z = -most(2); z <= most(2); ++z) shifts.push_back({x, y, z});
    }
  }
  return shifts;
}

/// Tells whether two simplices lie apart by more than rounding can do: rational numbers need not be
/// asked. Numbers here are below 100.
template <int Dim>
bool far_apart(const exact::Simplex<Dim>& a, const exact::Simplex<Dim>& b, const ImageShift& shift,
               const exact::Lattice& lattice) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    double move = 0.0;
    for (std::size_t k = 0; k < Dim; ++k) {
      if (lattice.periodic[k]) move += exact::numbers(shift)[k] * lattice.vectors[k][axis];
    }
    double behind = 1e9;
    double before = 1e9;
    for (std::size_t k = 0; k < a.size; ++k) {
      for (std::size_t j = 0; j < b.size; ++j) {
        const double difference = a.vertices[k][axis] - (b.vertices[j][axis] + move);
        behind = std::min(behind, difference);
        before = std::min(before, -difference);
      }
    }
    if (behind > 1e-6 || before > 1e-6) return true;
  }
  return false;
}

/// All contacts of one set, or of two.
template <std::size_t Dim, class A, class B>
std::vector<Contact> expected(const A& a, const B& b, const Domain& domain, SharedVertices shared,
                              bool one_set) {
  std::vector<Contact> contacts;
  const exact::Lattice lattice = elements::lattice_of(domain);
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    for (std::size_t j = one_set ? i : 0; j < b.cells.size(); ++j) {
      for (const ImageShift& n : shifts_of(domain)) {
        const bool is_zero = n == ImageShift{};
        if (one_set && i == j && std::tie(n.x, n.y, n.z) <= std::tuple(0, 0, 0)) continue;
        if (shared == SharedVertices::excluded && is_zero && share_vertex(a.cells[i], b.cells[j])) {
          continue;
        }
        const exact::Simplex<Dim> first = simplex_of<Dim>(a, i);
        const exact::Simplex<Dim> second = simplex_of<Dim>(b, j);
        if (far_apart(first, second, n, lattice) ||
            !hulls_meet_by_rationals(first, second, n, lattice)) {
          continue;
        }
        contacts.emplace_back(static_cast<ElementIndex>(i), static_cast<ElementIndex>(j), n.x, n.y,
                              n.z);
      }
    }
  }
  return contacts;
}

std::vector<Contact> contacts_of(const PairList& list) {
  std::vector<Contact> contacts;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto [i, j] = list.pairs()[k];
    const ImageShift n = list.shifts().empty() ? ImageShift{} : list.shifts()[k];
    contacts.emplace_back(i, j, n.x, n.y, n.z);
  }
  return contacts;
}

/// On a lattice of thirds, which are no doubles, so that nothing is as it would be with whole
/// numbers but by exact arithmetic.
template <std::size_t Dim, std::size_t Corners>
auto system_of(std::size_t cells, std::uint64_t seed) {
  auto system = random_system<Dim, Corners>(cells, seed);
  for (auto& vertex : system.vertices) {
    for (double& x : vertex) x /= 3.0;
  }
  return system;
}

template <std::size_t Dim, std::size_t Corners>
void compare(const Domain& domain, std::size_t cells, std::uint64_t seed) {
  const auto system = system_of<Dim, Corners>(cells, seed);
  for (const SharedVertices shared : {SharedVertices::touching, SharedVertices::excluded}) {
    const auto contacts = expected<Dim>(system, system, domain, shared, true);
    ASSERT_GT(contacts.size(), 20U);
    for (const Algorithm algorithm : {Algorithm::rows, Algorithm::direct_check}) {
      const PairList found = find_simplex_contacts(
          system.view(), domain, {.algorithm = algorithm, .shifts = Shifts::stored, .threads = 2},
          shared);
      EXPECT_EQ(contacts_of(found), contacts);
      EXPECT_EQ(found.statistics().contact_pairs, contacts.size());
    }
  }
}

TEST(PeriodicSimplices, Triangles) {
  compare<2, 3>(Domain::periodic({4.0, 11.0 / 3.0}), 40, 31);
}
TEST(PeriodicSimplices, TrianglesInOneDirection) {
  compare<2, 3>(Domain::periodic({2.1, unbounded}), 40, 32);
}
TEST(PeriodicSimplices, SegmentsUnderShear) {
  compare<2, 2>(Domain::lees_edwards({2.0, 7.0 / 3.0}, 1.1), 50, 33);
}
TEST(PeriodicSimplices, Tetrahedra) {
  compare<3, 4>(Domain::periodic({1.2, 4.0 / 3.0, 1.5}), 16, 34);
}
TEST(PeriodicSimplices, TrianglesInASkewedCell) {
  compare<3, 3>(Domain::lattice({2.0, 0.1, 0.0}, {0.7, 2.0, 0.2}, {-0.5, 0.4, 7.0 / 3.0}), 30, 35);
}

/// A cell so small that a tetrahedron touches many images, of its own too.
TEST(PeriodicSimplices, ManyImages) {
  SimplexSystem<3, 4> system;
  system.vertices = {{0, 0, 0}, {1.5, 0, 0}, {0, 1.5, 0}, {0, 0, 1.5}};
  system.cells = {{0, 1, 2, 3}};
  const Domain domain = Domain::periodic({1.0, 1.0, 1.0});
  const auto contacts = expected<3>(system, system, domain, SharedVertices::touching, true);
  ASSERT_GT(contacts.size(), 5U);
  const PairList found = find_simplex_contacts(system.view(), domain, {.shifts = Shifts::stored});
  EXPECT_EQ(contacts_of(found), contacts);
  // An image of a vertex is another vertex.
  EXPECT_EQ(find_simplex_contacts(system.view(), domain, {}, SharedVertices::excluded).size(),
            contacts.size());
}

TEST(PeriodicSimplices, TwoSets) {
  const auto triangles = system_of<3, 3>(40, 36);
  const auto segments = system_of<3, 2>(40, 37);
  const Domain domain = Domain::periodic({2.0, 2.0, unbounded});
  const auto contacts = expected<3>(triangles, segments, domain, SharedVertices::touching, false);
  ASSERT_GT(contacts.size(), 10U);
  const PairList found =
      find_simplex_contacts(triangles.view(), segments.view(), domain, {.shifts = Shifts::stored});
  EXPECT_EQ(contacts_of(found), contacts);
}

/// What the caller asks for decides what is stored, not what is found.
TEST(PeriodicSimplices, OrdersAndShifts) {
  const auto system = random_system<3, 3>(3000, 38);
  const Domain domain = Domain::periodic({16.0, 17.0, 18.0});
  const PairList expected_list =
      find_simplex_contacts(system.view(), domain, {.shifts = Shifts::stored, .threads = 1});
  const auto contacts = contacts_of(expected_list);
  ASSERT_GT(contacts.size(), 5000U);
  ASSERT_GT(contacts.size(), find_simplex_contacts(system.view()).size());
  const PairList without = find_simplex_contacts(system.view(), domain, {.threads = 3});
  EXPECT_TRUE(without.shifts().empty());
  EXPECT_TRUE(std::ranges::equal(without, expected_list));
  for (const int threads : {1, 4}) {
    const PairList found = find_simplex_contacts(
        system.view(), domain,
        {.order = Order::as_found, .shifts = Shifts::stored, .threads = threads});
    auto sorted = contacts_of(found);
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, contacts);
  }
  for (std::size_t k = 0; k < contacts.size(); k += 97) {
    EXPECT_TRUE(touching(system.view(), system.view(), domain, expected_list.pairs()[k],
                         expected_list.shifts()[k]));
  }
  EXPECT_FALSE(touching(system.view(), system.view(), domain, {0, 0}, {1, 0, 0}));
}

TEST(PeriodicSimplices, Errors) {
  const auto system = random_system<3, 3>(20, 39);
  const SimplexView view = system.view();
  const Domain slab = Domain::periodic({9.0, 9.0, unbounded});
  expect_error(ErrorCode::wrong_usage, {"munjiza_nbs", "periodic"}, [&] {
    static_cast<void>(find_simplex_contacts(view, slab, {.algorithm = Algorithm::munjiza_nbs}));
  });
  expect_error(ErrorCode::wrong_usage, {"2 dimensions"}, [&] {
    static_cast<void>(find_simplex_contacts(view, Domain::periodic({9.0, 9.0})));
  });
  expect_error(ErrorCode::wrong_usage, {"image shift z = 1"}, [&] {
    static_cast<void>(touching(view, view, slab, {0, 1}, {0, 0, 1}));
  });
  expect_error(ErrorCode::wrong_usage, {"2 dimensions"}, [&] {
    static_cast<void>(touching(view, view, Domain::periodic({9.0, 9.0}), {0, 1}, {0, 0, 0}));
  });
  const PairCount size = find_simplex_contacts(view, slab).size();
  expect_error(ErrorCode::limit_exceeded, {}, [&] {
    static_cast<void>(find_simplex_contacts(view, slab, {.max_pairs = size - 1}));
  });
}

}  // namespace
}  // namespace abut::testing
