// Candidates are in canonical order whatever the lengths of their runs, of which vectors sort the
// short ones some at a time.

#include "skin/candidate_layout.hpp"
#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "kernels/order_kernels.hpp"
#include "scenes/random.hpp"

#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using skin::ShiftNumber;

struct Candidate {
  ContactPair pair;
  ShiftNumber shift;

  bool operator==(const Candidate&) const = default;
};

bool comes_before(const Candidate& a, const Candidate& b) {
  return std::tie(a.pair, a.shift) < std::tie(b.pair, b.shift);
}

/// As many candidates of each element as `lengths` says, in any order. Partners lie near, or
/// anywhere.
std::vector<Candidate> some_candidates(Random& random, const std::vector<std::size_t>& lengths,
                                       bool near) {
  const auto count = static_cast<ElementIndex>(2 * lengths.size() + 100);
  std::vector<Candidate> candidates;
  for (std::size_t element = 0; element < lengths.size(); ++element) {
    for (std::size_t k = 0; k < lengths[element]; ++k) {
      const auto first = static_cast<ElementIndex>(element);
      const std::size_t behind = near ? 40 : count - first - 1;
      const ElementIndex second = first + 1 + static_cast<ElementIndex>(random.below(behind));
      candidates.push_back({{first, second}, static_cast<ShiftNumber>(random.below(1 << 16))});
    }
  }
  for (std::size_t k = candidates.size(); k > 1; --k) {
    std::swap(candidates[k - 1], candidates[random.below(k)]);
  }
  return candidates;
}

std::vector<Candidate> candidates_of(const skin::CandidateLayout& layout) {
  std::vector<Candidate> found;
  const std::size_t size = layout.candidates().size();
  const skin::CandidateLayout::Canonical canonical = layout.canonical();
  for (std::size_t k = 0; k < size; ++k) {
    found.push_back(layout.follows_space()
                        ? Candidate{layout.pair_of(layout.candidates()[k]), layout.shifts()[k]}
                        : Candidate{canonical.pairs[k], canonical.shifts[k]});
  }
  return found;
}

void expect_canonical(std::vector<Candidate> given, std::size_t elements, bool near) {
  std::vector<ContactPair> pairs;
  std::vector<ShiftNumber> shifts;
  for (const Candidate& candidate : given) {
    pairs.push_back(candidate.pair);
    shifts.push_back(candidate.shift);
  }
  std::sort(given.begin(), given.end(), comes_before);
  const std::span<const ContactPair> piece = pairs;
  for (const Simd level : simd_levels()) {
    if (!available(level)) continue;
    for (const std::size_t workers : {std::size_t{1}, std::size_t{3}}) {
      SCOPED_TRACE(std::string(name_of(level)) + ", workers " + std::to_string(workers));
      base::MemoryMeter memory;
      base::ProgressReporter progress;
      base::WorkCounter work(progress, 0);
      skin::CandidateLayout layout(memory);
      layout.use(kernels::order_kernels(level));
      layout.arrange(lists::PairPieces(&piece, 1), shifts, elements, workers, work);
      EXPECT_EQ(layout.follows_space(), near);
      ASSERT_EQ(candidates_of(layout), given);
    }
  }
}

TEST(CandidateLayout, RunsOfAllLengthsAreInCanonicalOrder) {
  Random random(2511);
  const std::vector<std::size_t> around{0,   1,   2,   3,   4,   7,   8,   9,   15,  16,
                                        17,  31,  32,  33,  63,  64,  65,  66,  100, 127,
                                        129, 447, 448, 449, 511, 512, 513, 700, 1500};
  for (const bool near : {false, true}) {
    std::vector<std::size_t> lengths;
    for (int k = 0; k < 400; ++k) lengths.push_back(around[random.below(around.size())]);
    expect_canonical(some_candidates(random, lengths, near), 2 * lengths.size() + 100, near);
  }
}

/// Some that fill the buffer to the last key, and empty ones behind them.
TEST(CandidateLayout, RunsThatFillABufferAreInCanonicalOrder) {
  Random random(2512);
  for (const std::size_t length : std::vector<std::size_t>{1, 8, 16, 32, 64}) {
    std::vector<std::size_t> lengths(300, length);
    lengths.resize(500, 0);
    expect_canonical(some_candidates(random, lengths, false), 2 * lengths.size() + 100, false);
  }
}

TEST(CandidateLayout, NoneAndOne) {
  Random random(2513);
  expect_canonical({}, 10, false);
  expect_canonical(some_candidates(random, {1}, false), 102, false);
}

}  // namespace
}  // namespace abut::testing
