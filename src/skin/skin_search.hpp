#pragma once

#include "base/detection_context.hpp"
#include "base/pair_sink.hpp"
#include "elements/element_ids.hpp"
#include "skin/candidate_insertion.hpp"
#include "skin/candidate_pairs.hpp"
#include "skin/displacement_tracker.hpp"
#include "skin/elements_now.hpp"
#include "skin/given_spheres.hpp"

#include <abut/element_view.hpp>
#include <abut/error.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace abut::skin {

/// The names of elements; the version changes whenever they do.
struct NamedElements {
  const elements::ElementIds& ids;
  std::uint64_t version;
};

/// Candidate pairs found once, with a skin, for as many calls as they last: until two elements may
/// have come closer by more than the skin (docs/derivations/skin.md).
template <int Dim>
class SkinSearch {
 public:
  explicit SkinSearch(base::MemoryMeter& memory) : memory_(memory) { release(); }

  /// True if the kept candidates hold all contact pairs of these elements. Throws as a detection
  /// does for an invalid domain.
  [[nodiscard]] bool covers(const ElementsNow<Dim>& now, const NamedElements& named);

  /// The same of elements that nobody has gathered; leaves them where deliver_contacts() needs
  /// them. False also where only covers() can tell, or an element is invalid.
  [[nodiscard]] bool covers(const ElementView& given, const CallNow& now,
                            const NamedElements& named);

  /// New elements at their anchors, which are to be searched for against all.
  struct Insertion {
    std::span<const exact::Sphere<Dim>> added;
    std::span<const exact::Sphere<Dim>> all;
    const Domain& domain;
    double margin;
    base::PairSink& sink;
  };

  /// Carries the candidates over to elements of which some came, went or have other numbers. Calls
  /// `search(insertion)` if some are new, but few. Returns false if that does not pay.
  template <class Search>
  [[nodiscard]] bool carry_over(const ElementsNow<Dim>& now, const NamedElements& named,
                                Search&& search);

  /// The number of elements that were new when candidates were carried over.
  [[nodiscard]] std::size_t added() const noexcept { return added_.size(); }

  /// The length by which two elements may have come closer, as covers() found; infinite if unknown.
  [[nodiscard]] double approach() const noexcept { return approach_; }

  /// Keeps what `search(margin, sink)` finds with the skin `next_skin(reach)`, where the reach is
  /// that of two elements of mean size. False if that cannot be kept, because the memory bound or
  /// the range of image shifts leave no room for more than was asked for, or because there are far
  /// too many; it is not tried again for some calls then.
  template <class NextSkin, class Search>
  [[nodiscard]] bool find_candidates(const ElementsNow<Dim>& now, const NamedElements& named,
                                     NextSkin&& next_skin, Search&& search);

  /// Delivers the contacts; needs covers(), carry_over() or find_candidates() for the same elements
  /// before.
  void deliver_contacts(const ElementsNow<Dim>& now, base::PairSink& sink,
                        base::DetectionContext& context) {
    candidates_->fill_slots(now, *tracker_);
    candidates_->deliver_contacts(now, GivenSpheres<Dim>(now.spheres), *tracker_, sink, context);
  }

  /// Of elements that nobody has gathered.
  void deliver_contacts(const ElementView& given, const CallNow& now, base::PairSink& sink,
                        base::DetectionContext& context) {
    candidates_->deliver_contacts(now, GivenSpheres<Dim>(given), *tracker_, sink, context);
  }

  [[nodiscard]] PairCount candidates() const noexcept { return candidates_->size(); }
  [[nodiscard]] double skin() const noexcept { return skin_; }

  /// Drops the candidates and their memory.
  void release();

 private:
  static constexpr int calls_without = 64;

  /// New elements are at most one in so many; with more, all candidates are searched for anew.
  static constexpr std::size_t elements_for_a_new_one = 16;

  [[nodiscard]] double allowed(const CallNow& now) const noexcept;
  [[nodiscard]] bool follow(const ElementsNow<Dim>& now, const NamedElements& named);
  void list_added();
  void remember(const NamedElements& named);

  /// Returns what `body` returns; returns false and drops the candidates if memory does not
  /// suffice.
  template <class Body>
  [[nodiscard]] bool if_there_is_room(Body&& body);

  [[nodiscard]] bool give_up() {
    release();
    pause_ = calls_without;
    return false;
  }

  base::MemoryMeter& memory_;
  std::optional<DisplacementTracker<Dim>> tracker_;
  std::optional<CandidatePairs<Dim>> candidates_;
  bool valid_ = false;
  double margin_ = 0.0;  ///< that candidates were found with, skin included
  double skin_ = 0.0;
  double approach_ = std::numeric_limits<double>::infinity();
  int pause_ = 0;  ///< calls before candidates are tried again

  elements::ElementIds ids_;  ///< of the elements that candidates are kept of
  std::uint64_t version_ = 0;
  std::vector<std::uint32_t> before_;  ///< for each element now its number then
  std::vector<std::uint32_t> after_;   ///< for each element then its number now
  std::vector<ElementIndex> added_;
  std::vector<exact::Sphere<Dim>> added_spheres_;
  CandidateInsertion<Dim> insertion_;
};

template <int Dim>
template <class Body>
bool SkinSearch<Dim>::if_there_is_room(Body&& body) {
  try {
    return body() || give_up();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::limit_exceeded && error.code() != ErrorCode::invalid_input) {
      throw;
    }
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return give_up();
}

template <int Dim>
template <class NextSkin, class Search>
bool SkinSearch<Dim>::find_candidates(const ElementsNow<Dim>& now, const NamedElements& named,
                                      NextSkin&& next_skin, Search&& search) {
  valid_ = false;
  if (pause_ > 0) {
    --pause_;
    return false;
  }
  return if_there_is_room([&] {
    if (!tracker_->start(now)) return false;
    skin_ = next_skin(2.0 * tracker_->mean_radius() + now.margin);
    margin_ = now.margin + skin_;
    if (!(margin_ < std::numeric_limits<double>::infinity())) return false;
    if (CandidatePairs<Dim>::too_many_shifts(now.domain, margin_)) return false;
    search(margin_, candidates_->start_anew(now.spheres.size(), now.domain.is_periodic()));
    if (!candidates_->finish(now, *tracker_)) return false;
    remember(named);
    return valid_ = true;
  });
}

template <int Dim>
template <class Search>
bool SkinSearch<Dim>::carry_over(const ElementsNow<Dim>& now, const NamedElements& named,
                                 Search&& search) {
  if (!valid_ || version_ == named.version) return false;
  valid_ = false;
  return if_there_is_room([&] {
           if (!follow(now, named)) return true;
           base::PairSink& sink = candidates_->carry_over(after_, *tracker_, now.work);
           if (!added_.empty()) {
             insertion_.start_anew(sink, added_, before_, *tracker_);
             search(Insertion{added_spheres_, tracker_->anchors(), tracker_->domain_then(), margin_,
                              insertion_});
           }
           if (!candidates_->finish(now, *tracker_)) return false;
           remember(named);
           return valid_ = true;
         }) &&
         valid_;
}

}  // namespace abut::skin
