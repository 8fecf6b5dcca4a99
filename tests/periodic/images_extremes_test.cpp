// Images of elements that lie far out, reach far, or lie in a cell of very unequal sides.

#include "periodic/images.hpp"

#include "base/progress_reporter.hpp"
#include "kernels/simd_level.hpp"
#include "lattice/lattices.hpp"
#include "periodic/periodic_search.hpp"

#include <abut/error.hpp>
#include <abut/progress.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

template <class Act>
std::string error_of(ErrorCode code, Act&& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  return "";
}

TEST(ImagesOfFarElements, AreRefusedBeyond31Bits) {
  PeriodicSystem<2> system;
  system.lattice.vectors = {{{1, 0, 0}, {0, 1, 0}, {}}};
  system.lattice.periodic = {true, false, false};
  system.spheres = {{{0.25, 0.0}, 0.5}, {{2147483647.25, 1e300}, 0.5}};
  EXPECT_EQ(pairs_by_images(system).size(), 2u) << "each with itself";
  system.spheres[1] = {{2147483000.25, 0.0}, 0.5};
  EXPECT_EQ(pairs_by_images(system).size(), 2u + 3u);
  system.spheres.push_back({{-2147483647.5, 1.0}, 0.0});
  system.spheres.push_back({{0.5, -1e10}, 0.0});
  system.spheres.push_back({{2147483648.5, 1.0}, 0.0});
  system.spheres.push_back({{1e300, 1.0}, 0.0});
  EXPECT_EQ(error_of(ErrorCode::invalid_input, [&] { (void)pairs_by_images(system); }),
            "element 2 has x = -2147483647.5; it lies more than 2147483647 cells outside of the "
            "periodic cell: move it into the cell, or correct the lattice");
  system.spheres[2].center[0] = 0.0;
  EXPECT_EQ(error_of(ErrorCode::invalid_input, [&] { (void)pairs_by_images(system); })
                .find("element 4 has x = 2147483648.5; "),
            0u);
}

TEST(ImagesOfFarElements, ShiftsBeyond31BitsAreRefused) {
  PeriodicSystem<2> system;
  system.lattice.vectors = {{{1, 0, 0}, {0, 1, 0}, {}}};
  system.lattice.periodic = {true, true, false};
  system.spheres = {{{-2147483000.0, 0.0}, 0.25}, {{2147483000.25, 0.0}, 0.25}};
  EXPECT_EQ(error_of(ErrorCode::invalid_input, [&] { (void)pairs_by_images(system); }),
            "elements 0 and 1 pair across more than 2147483647 lattice vectors; move them into one "
            "cell");
}

/// Locals lie on both sides of a face along c, and are moved along a and b. Moved along c, too, for
/// the hair by which that changes their coordinate, some of them would lie a c from the others.
TEST(ImagesInLongCells, LocalsStayTogether) {
  Random random(41);
  for (const int exponent : {5, 12, 20, 27, 35, 50, 61}) {
    PeriodicSystem<3> system;
    system.lattice.vectors = {
        {{72.0, 8.0, -32.0}, {80.0, 40.0, 80.0}, {72.0, std::ldexp(75.0, exponent), 40.0}}};
    system.lattice.periodic = {true, true, true};
    for (int k = 0; k < 12; ++k) {
      const auto place = [&] { return random.uniform(-900.0, 900.0); };
      system.spheres.push_back({{place(), place(), place()}, random.uniform(4.0, 30.0)});
    }
    const lattice::ReducedLattice<3> reduced(system.lattice);
    base::MemoryMeter memory;
    auto elements = array_of(system.spheres, memory);
    periodic::Images<3> images(memory);
    images.find(elements, bounds_of<3>(system.spheres), reduced,
                {0.0, 1, kernels::image_kernels(Simd::scalar)});
    ASSERT_LT(images.slack(), 1e-6) << exponent;
    ASSERT_FALSE(images.reach_is_long()) << exponent;
    ASSERT_EQ(pairs_by_images(system), pairs_by_rationals(system)) << exponent;
  }
}

/// Images of one element: so many for each local element are not stored.
TEST(ImagesOfLargeReach, AreNotStored) {
  exact::Lattice lattice;
  lattice.vectors = {{{1, 0, 0}, {0, 1, 0}, {}}};
  lattice.periodic = {true, true, false};
  const lattice::ReducedLattice<2> reduced(lattice);
  for (const double radius : {1.0, 2.0, 1e5}) {
    base::MemoryMeter memory;
    std::vector<exact::Sphere<2>> spheres{{{0.0, 0.0}, radius}};
    auto elements = array_of(spheres, memory);
    periodic::Images<2> images(memory);
    images.find(elements, bounds_of<2>(spheres), reduced,
                {0.0, 1, kernels::image_kernels(Simd::scalar)});
    EXPECT_EQ(images.reach_is_long(), radius > 1.0) << "12, 40 and 80,000,400,000 images";
    EXPECT_EQ(images.ghosts().empty(), radius > 1.0);
    EXPECT_LT(memory.peak(), 2000u);
  }
}

/// A large element among many small ones has so many images that listing them takes a while.
TEST(ImagesOfLargeReach, AskTheHookWhileTheyAreListed) {
  exact::Lattice lattice;
  lattice.vectors = {{{1, 0, 0}, {0, 1, 0}, {}}};
  lattice.periodic = {true, true, false};
  const lattice::ReducedLattice<2> reduced(lattice);
  std::vector<exact::Sphere<2>> spheres(120000, exact::Sphere<2>{{0.5, 0.5}, 0.0});
  spheres[7].radius = 260.0;
  for (const std::size_t workers : {1u, 3u}) {
    base::MemoryMeter memory;
    auto elements = array_of(spheres, memory);
    int calls = 0;
    const ProgressHook hook = [&calls](const Progress&) {
      ++calls;
      return ProgressAction::proceed;
    };
    base::ProgressReporter progress(hook);
    periodic::Images<2> images(memory);
    periodic::ImageSettings settings{0.0, workers, kernels::image_kernels(Simd::scalar)};
    settings.size_cut = 1.0;
    settings.progress = &progress;
    images.find(elements, bounds_of<2>(spheres), reduced, settings);
    EXPECT_GT(images.ghosts().size(), 1000000u);
    EXPECT_GE(calls, 5);
    if (workers > 1) continue;
    calls = 0;
    const ProgressHook cancel = [&calls](const Progress&) {
      return ++calls < 3 ? ProgressAction::proceed : ProgressAction::cancel;
    };
    base::ProgressReporter cancelling(cancel);
    settings.progress = &cancelling;
    elements.resize(spheres.size());
    EXPECT_NE(error_of(ErrorCode::cancelled,
                       [&] { images.find(elements, bounds_of<2>(spheres), reduced, settings); })
                  .find("cancelled"),
              std::string::npos);
    EXPECT_EQ(calls, 3);
  }
}

TEST(ImagesOfLargeReach, BeyondAllShiftsIsRefused) {
  PeriodicSystem<2> system;
  system.lattice.vectors = {{{1, 0, 0}, {0, 1, 0}, {}}};
  system.lattice.periodic = {true, true, false};
  for (const double radius : {1e10, 1e300}) {
    system.spheres = {{{0.0, 0.0}, 1.0}, {{0.5, 0.0}, radius}};
    EXPECT_EQ(error_of(ErrorCode::invalid_input, [&] { (void)pairs_by_images(system); })
                  .find("element 1 has radius = 1e+"),
              0u)
        << radius;
  }
}

}  // namespace
}  // namespace abut::testing
