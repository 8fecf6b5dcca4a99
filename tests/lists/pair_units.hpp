#pragma once

#include "base/pair_sink.hpp"
#include "base/progress_reporter.hpp"
#include "lists/found_pairs.hpp"
#include "scenes/random.hpp"
#include "support/oracle.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace abut::testing {

using scenes::Random;

/// Any shift that tells the pair.
inline ImageShift shift_of(const ContactPair& pair) {
  return {static_cast<std::int32_t>(pair.first), -static_cast<std::int32_t>(pair.second), 7};
}

/// Units of pairs, found by workers in any order; each unit's pairs in one worker, in several
/// commits.
struct Units {
  static constexpr std::size_t elements = 5000;

  std::vector<PairVector> pairs;

  explicit Units(std::uint64_t seed, std::size_t of_large_unit = 20000) {
    Random random(seed);
    for (std::size_t unit = 0; unit < 60; ++unit) {
      PairVector here(random.below(10) == 0 ? of_large_unit : random.below(300));
      for (ContactPair& pair : here) {
        pair.first = static_cast<ElementIndex>(random.below(elements - 1));
        pair.second =
            static_cast<ElementIndex>(pair.first + 1 + random.below(elements - 1 - pair.first));
      }
      pairs.push_back(std::move(here));
    }
    // Each pair once, as detections find them.
    std::set<ContactPair> seen;
    for (PairVector& unit : pairs) {
      std::erase_if(unit, [&](const ContactPair& pair) { return !seen.insert(pair).second; });
    }
  }

  [[nodiscard]] PairVector together() const {
    PairVector result;
    for (const PairVector& unit : pairs) result.insert(result.end(), unit.begin(), unit.end());
    return result;
  }

  void deliver(lists::FoundPairs& found, std::size_t workers, std::uint64_t seed) const {
    Random random(seed);
    found.expect_workers(workers);
    std::vector<std::size_t> order(pairs.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    for (std::size_t left = order.size(); left > 1; --left) {
      std::swap(order[left - 1], order[random.below(left)]);
    }
    for (const std::size_t unit : order) {
      deliver_unit(found, unit, random.below(workers), random);
    }
  }

  /// By a single worker, which tells after each unit that it is done.
  void deliver_in_order(lists::FoundPairs& found, base::ProgressReporter& progress) const {
    Random random(1);
    found.expect_workers(1);
    progress.begin("search", pairs.size());
    for (std::size_t unit = 0; unit < pairs.size(); ++unit) {
      deliver_unit(found, unit, 0, random);
      progress.advance(1);
    }
  }

  /// By workers that take one unit after the other and find a few pairs each in turn.
  void deliver_in_turns(lists::FoundPairs& found, std::size_t workers, std::uint64_t seed,
                        base::ProgressReporter& progress) const {
    struct Turn {
      std::size_t unit = 0;
      std::size_t done = 0;
      bool is_busy = false;
    };
    Random random(seed);
    found.expect_workers(workers);
    progress.begin("search", pairs.size());
    found.expect_units(0, pairs.size());
    std::vector<Turn> turns(workers);
    for (std::size_t next = 0, finished = 0; finished < pairs.size();) {
      const std::size_t worker = random.below(workers);
      Turn& turn = turns[worker];
      if (!turn.is_busy && next == pairs.size()) continue;
      if (!turn.is_busy) {
        turn = {next++, 0, true};
        found.begin_unit({worker, turn.unit});
      } else if (turn.done < pairs[turn.unit].size()) {
        turn.done += deliver_some(found, turn.unit, turn.done, worker, random);
      } else {
        found.finish_unit({worker, turn.unit});
        progress.advance(1);
        turn.is_busy = false;
        ++finished;
      }
    }
  }

  void deliver_unit(lists::FoundPairs& found, std::size_t unit, std::size_t worker,
                    Random& random) const {
    for (std::size_t done = 0; done < pairs[unit].size();) {
      done += deliver_some(found, unit, done, worker, random);
    }
  }

  /// Returns how many.
  std::size_t deliver_some(lists::FoundPairs& found, std::size_t unit, std::size_t done,
                           std::size_t worker, Random& random) const {
    const auto room = found.buffer(worker);
    EXPECT_GE(room.size(), base::PairSink::smallest_buffer);
    const std::size_t count =
        std::min({room.size(), pairs[unit].size() - done, 1 + random.below(5000)});
    const std::span piece = std::span(pairs[unit]).subspan(done, count);
    std::copy(piece.begin(), piece.end(), room.begin());
    const auto shifts = found.shift_buffer(worker);
    if (!shifts.empty()) {
      EXPECT_GE(shifts.size(), count);
      std::transform(piece.begin(), piece.end(), shifts.begin(), shift_of);
    }
    found.commit(count, {worker, unit});
    return count;
  }
};

}  // namespace abut::testing
