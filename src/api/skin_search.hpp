#pragma once

#include "api/candidate_pairs.hpp"
#include "api/displacement.hpp"
#include "api/skin_choice.hpp"
#include "api/snapshot.hpp"
#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"

#include <abut/error.hpp>
#include <abut/pair.hpp>

#include <limits>
#include <new>
#include <optional>
#include <stdexcept>

namespace abut::api {

/// Candidate pairs found once, with a skin, for as many calls as they last: until two elements may
/// have come closer by more than the skin (docs/derivations/skin.md).
template <int Dim>
class SkinSearch {
 public:
  explicit SkinSearch(base::MemoryMeter& memory) : memory_(memory) { release(); }

  /// Whether the candidates that are kept hold all contact pairs of these elements. Throws as a
  /// detection does where the domain is none.
  [[nodiscard]] bool covers(const Snapshot<Dim>& now);

  /// How much closer two elements may have come, as covers() found; infinite where that is unknown.
  [[nodiscard]] double approach() const noexcept { return approach_; }

  /// Keeps what `search(margin, sink)` finds with the skin of `choice`. False if that cannot be
  /// kept, because the memory bound or the range of image shifts leave no room for more than was
  /// asked for; it is not tried again for some calls then.
  template <class Search>
  [[nodiscard]] bool find_candidates(const Snapshot<Dim>& now, SkinChoice& choice, Search&& search);

  /// After covers() or find_candidates() for the same elements.
  void deliver_contacts(const Snapshot<Dim>& now, base::PairSink& sink,
                        base::DetectionContext& context) {
    candidates_->deliver_contacts(now, *displacement_, sink, context);
  }

  [[nodiscard]] PairCount candidates() const noexcept { return candidates_->size(); }
  [[nodiscard]] double skin() const noexcept { return skin_; }

  /// Drops the candidates and their memory.
  void release();

 private:
  static constexpr int calls_without = 64;

  [[nodiscard]] bool give_up() {
    release();
    pause_ = calls_without;
    return false;
  }

  base::MemoryMeter& memory_;
  std::optional<Displacement<Dim>> displacement_;
  std::optional<CandidatePairs<Dim>> candidates_;
  bool valid_ = false;
  double margin_ = 0.0;  ///< that candidates were found with, skin included
  double skin_ = 0.0;
  double approach_ = std::numeric_limits<double>::infinity();
  int pause_ = 0;  ///< calls before candidates are tried again
};

template <int Dim>
template <class Search>
bool SkinSearch<Dim>::find_candidates(const Snapshot<Dim>& now, SkinChoice& choice,
                                      Search&& search) {
  valid_ = false;
  if (pause_ > 0) {
    --pause_;
    return false;
  }
  try {
    if (!displacement_->start(now)) return give_up();
    skin_ = choice.next_length(2.0 * displacement_->mean_radius() + now.margin, Dim);
    margin_ = now.margin + skin_;
    if (!(margin_ < std::numeric_limits<double>::infinity())) return give_up();
    search(margin_, candidates_->start_anew(now.domain.is_periodic()));
    valid_ = candidates_->finish(now, *displacement_);
    return valid_ || give_up();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::limit_exceeded && error.code() != ErrorCode::invalid_input) {
      throw;
    }
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return give_up();
}

}  // namespace abut::api
