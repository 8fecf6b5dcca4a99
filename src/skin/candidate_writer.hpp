#pragma once

#include "base/pair_sink.hpp"
#include "kernels/candidate_kernels.hpp"
#include "skin/candidate_layout.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::skin {

/// Writes the candidates that survived into a sink, one unit of work long.
class CandidateWriter {
 public:
  /// Candidates written at a time.
  static constexpr std::size_t most = 256;
  static_assert(base::PairSink::smallest_buffer >= most);

  /// `survivors` has a bit for each candidate, by its place in the order of space.
  CandidateWriter(base::PairSink& sink, const base::Origin& origin, const std::uint64_t* survivors)
      : sink_(sink), origin_(origin), survivors_(survivors) {}

  /// Writes the survivors among `count` candidates, from `first` on in canonical order; shift_at(k)
  /// is the image shift of candidate k of all.
  template <class ShiftAt>
  void write(const CandidateLayout::Canonical& candidates, std::size_t first, std::size_t count,
             ShiftAt&& shift_at) {
    if (room_.size() - filled_ < count) take_room();
    // Without a branch: whether it survives cannot be guessed.
    std::size_t kept = 0;
    if (shifts_.empty()) {
      ContactPair* const pairs = room_.data() + filled_;
      for (std::size_t k = first; k < first + count; ++k) {
        pairs[kept] = candidates.pairs[k];
        kept += survives(candidates.places[k]) ? 1 : 0;
      }
    } else {
      std::array<std::uint32_t, most> survivors;
      for (std::size_t k = first; k < first + count; ++k) {
        survivors[kept] = static_cast<std::uint32_t>(k);
        kept += survives(candidates.places[k]) ? 1 : 0;
      }
      for (std::size_t k = 0; k < kept; ++k) {
        room_[filled_ + k] = candidates.pairs[survivors[k]];
        shifts_[filled_ + k] = shift_at(survivors[k]);
      }
    }
    filled_ += kept;
  }

  /// Writes the survivors among candidates whose order is canonical, and whose slots are elements;
  /// shift_at(k) is the image shift of the k-th of them. They begin with a word of `survivors`.
  template <class ShiftAt>
  void write_in_order(std::span<const SlotPair> candidates,
                      const kernels::CandidateKernels& kernels, ShiftAt&& shift_at) {
    for (std::size_t word = 0; bits * word < candidates.size();) {
      if (room_.size() - filled_ < bits) take_room();
      const SlotPair* const pairs = candidates.data() + bits * word;
      const std::size_t words =
          std::min((candidates.size() - bits * word) / bits, (room_.size() - filled_) / bits);
      kernels::KeptCandidates kept =
          kernels.keep(pairs, survivors_ + word, words, room_.data() + filled_);
      if (kept.words == 0) kept = write_word(pairs, survivors_[word]);
      if (!shifts_.empty()) write_shifts(word, kept.words, shift_at);
      filled_ += kept.pairs;
      word += kept.words;
    }
  }

  void finish() {
    const std::size_t count = filled_;
    filled_ = 0;
    room_ = {};
    if (count > 0) sink_.commit(count, origin_);
  }

 private:
  static constexpr std::size_t bits = 64;  ///< of a word of survivors

  /// Writes the survivors of one word.
  kernels::KeptCandidates write_word(const SlotPair* candidates, std::uint64_t survivors) {
    ContactPair* next = room_.data() + filled_;
    for (; survivors != 0; survivors &= survivors - 1) {
      const SlotPair& pair = candidates[std::countr_zero(survivors)];
      *next++ = {pair.first, pair.second};
    }
    return {1, static_cast<std::size_t>(next - room_.data()) - filled_};
  }

  /// Writes the shifts of the survivors of some words.
  template <class ShiftAt>
  void write_shifts(std::size_t word, std::size_t words, const ShiftAt& shift_at) {
    ImageShift* next = shifts_.data() + filled_;
    for (const std::size_t end = word + words; word < end; ++word) {
      for (std::uint64_t rest = survivors_[word]; rest != 0; rest &= rest - 1) {
        *next++ = shift_at(bits * word + static_cast<std::size_t>(std::countr_zero(rest)));
      }
    }
  }

  [[nodiscard]] bool survives(std::uint32_t place) const noexcept {
    return (survivors_[place / 64] >> (place % 64) & 1) != 0;
  }

  void take_room() {
    finish();
    room_ = sink_.buffer(origin_.worker);
    shifts_ = sink_.shift_buffer(origin_.worker);
  }

  base::PairSink& sink_;
  base::Origin origin_;
  const std::uint64_t* survivors_;
  std::span<ContactPair> room_;
  std::span<ImageShift> shifts_;
  std::size_t filled_ = 0;
};

}  // namespace abut::skin
