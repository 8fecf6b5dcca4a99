#pragma once

#include "device/memory/kept_memory.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <new>
#include <utility>
#include <vector>

namespace abut::testing {

/// What a made-up call does with its blocks, one step after the other.
class BlockScript {
 public:
  struct Step {
    std::uint64_t bytes;  ///< of a block that is taken, or 0
    std::size_t block;    ///< that is given back if none is taken, by the order of taking
  };

  /// Takes so many blocks, of 1 byte to a million, and gives them back, at most `at_once` of them
  /// there at the same time.
  BlockScript(scenes::Random& random, std::size_t blocks, std::size_t at_once) {
    std::vector<std::size_t> there;
    for (std::size_t taken = 0; taken < blocks || !there.empty();) {
      const double part = 0.3 + 0.3 * random.uniform();
      const bool gives_back =
          taken == blocks || there.size() == at_once || (!there.empty() && random.uniform() < part);
      if (!gives_back) {
        there.push_back(taken++);
        steps_.push_back({static_cast<std::uint64_t>(std::exp2(random.uniform(0.0, 20.0))), 0});
        continue;
      }
      // Nearly always one of the last.
      const std::size_t back = random.uniform() < 0.8 ? 1 : 1 + random.below(there.size());
      const auto which = there.end() - static_cast<std::ptrdiff_t>(back);
      steps_.push_back({0, *which});
      there.erase(which);
    }
  }

  /// The same with other sizes, each a part of its own of what it was.
  [[nodiscard]] BlockScript scaled(scenes::Random& random, double least, double most) const {
    BlockScript script = *this;
    for (Step& step : script.steps_) {
      if (step.bytes == 0) continue;
      const double bytes = static_cast<double>(step.bytes) * random.uniform(least, most);
      step.bytes = static_cast<std::uint64_t>(bytes) + (step.bytes > 1 ? 0 : 1);
      if (step.bytes == 0) step.bytes = 1;
    }
    return script;
  }

  /// The same, but that some blocks are missing.
  [[nodiscard]] BlockScript without_some(scenes::Random& random, double part) const {
    BlockScript script = *this;
    script.steps_.clear();
    std::map<std::size_t, std::size_t> numbers;  ///< of the blocks that are left, by those here
    std::size_t taken = 0;
    for (const Step& step : steps_) {
      if (step.bytes == 0) {
        const auto found = numbers.find(step.block);
        if (found != numbers.end()) script.steps_.push_back({0, found->second});
        continue;
      }
      if (random.uniform() >= part) {
        numbers.emplace(taken, numbers.size());
        script.steps_.push_back(step);
      }
      ++taken;
    }
    return script;
  }

  [[nodiscard]] const std::vector<Step>& steps() const noexcept { return steps_; }

  /// Most bytes at once, of blocks as they are aligned.
  [[nodiscard]] std::uint64_t most_held() const {
    std::vector<std::uint64_t> sizes;
    std::uint64_t held = 0;
    std::uint64_t most = 0;
    for (const Step& step : steps_) {
      if (step.bytes == 0) {
        held -= sizes[step.block];
      } else {
        sizes.push_back((step.bytes + 255) / 256 * 256);
        most = std::max(most, held += sizes.back());
      }
    }
    return most;
  }

 private:
  std::vector<Step> steps_;
};

/// Blocks of a call that is running. No two of them may have a byte in common; all are given back
/// in the end, also where one could not be had.
class RunningBlocks {
 public:
  explicit RunningBlocks(device::KeptMemory& memory) : memory_(memory) {}
  RunningBlocks(const RunningBlocks&) = delete;
  RunningBlocks& operator=(const RunningBlocks&) = delete;
  ~RunningBlocks() {
    for (const auto& [address, bytes] : there_) memory_.give_back(address, bytes);
  }

  void run(const BlockScript& script) {
    for (const BlockScript::Step& step : script.steps()) {
      if (step.bytes == 0) {
        give_back(step.block);
      } else {
        take(step.bytes);
      }
    }
  }

 private:
  void take(std::uint64_t bytes) {
    auto* const block = static_cast<std::byte*>(memory_.take(bytes));
    if (block == nullptr) throw std::bad_alloc();
    const auto behind = there_.lower_bound(block);
    EXPECT_TRUE(behind == there_.end() || block + bytes <= behind->first);
    if (behind != there_.begin()) {
      const auto& [before, bytes_before] = *std::prev(behind);
      EXPECT_LE(before + bytes_before, block);
    }
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % 256, 0U);
    try {
      there_.emplace(block, bytes);
    } catch (...) {
      memory_.give_back(block, bytes);
      throw;
    }
    in_order_.push_back(block);
  }

  void give_back(std::size_t number) {
    const auto found = there_.find(in_order_[number]);
    memory_.give_back(found->first, found->second);
    there_.erase(found);
  }

  device::KeptMemory& memory_;
  std::map<std::byte*, std::uint64_t> there_;  ///< bytes
  std::vector<std::byte*> in_order_;           ///< in which they were taken
};

/// Runs it as a call of a detector; returns the most bytes held.
inline std::uint64_t run_call(device::KeptMemory& memory, const BlockScript& script,
                              std::uint64_t max_bytes = base::MemoryMeter::unbounded) {
  return memory.run(max_bytes, {}, [&] {
    RunningBlocks(memory).run(script);
    return memory.peak();
  });
}

}  // namespace abut::testing
