#pragma once

#include "base/array.hpp"
#include "base/asking_workers.hpp"
#include "base/callers_exception.hpp"
#include "base/detection_context.hpp"
#include "base/lack_of_memory.hpp"
#include "base/memory_meter.hpp"
#include "base/stopwatch.hpp"
#include "exact/box.hpp"
#include "exact/sphere.hpp"
#include "kernels/simd_level.hpp"
#include "lists/found_pairs.hpp"
#include "lists/result_buffer.hpp"
#include "walls/measure_contacts.hpp"

#include <abut/contact_list.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/image_shift.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/statistics.hpp>

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace abut::walls {

/// A box around all that lies within radius + margin of the center; what is beyond the largest
/// double is left out.
template <int Dim>
[[nodiscard]] exact::Box<Dim> box_around(const exact::Sphere<Dim>& sphere, double margin) noexcept;

/// Throws Error{limit_exceeded} for more contacts than the options allow.
void require_allowed(PairCount contacts, const Options& options);

/// A contact with one image of what is touched.
template <class Contact>
struct ImageContact {
  Contact contact;
  ImageShift shift;

  friend constexpr auto operator<=>(const ImageContact&, const ImageContact&) = default;
};

/// Contacts that one worker found, in ascending order.
template <class Contact>
struct alignas(128) FoundContacts {
  explicit FoundContacts(base::MemoryMeter& memory)
      : contacts(base::make_array_for_overwrite<ImageContact<Contact>>(memory, 0)),
        room(base::make_array_for_overwrite<ImageContact<Contact>>(memory, 0)) {}

  base::Array<ImageContact<Contact>> contacts;
  base::Array<ImageContact<Contact>> room;  ///< for whatever `find` needs
  std::uint64_t exact_decisions = 0;
};

/// A sphere and the boxes around something else that the box around it meets.
template <int Dim>
struct SphereCandidates {
  ElementIndex number;
  const exact::Sphere<Dim>& sphere;
  std::span<const ContactPair> pairs;  ///< `second` are the others, ascending
  std::span<const ImageShift> shifts;  ///< of the others, ascending for each; empty in open space

  [[nodiscard]] ImageShift shift(std::size_t k) const noexcept {
    return shifts.empty() ? ImageShift{} : shifts[k];
  }
};

/// Finds pairs of a sphere and a box around something else that the box around the sphere meets:
/// the candidates with which a search for contacts with features begins.
template <int Dim>
class FeatureSearch {
 public:
  /// Throws as a detection of two sets does. `options` must outlive it.
  FeatureSearch(const ElementView& spheres, const ElementView& boxes, const Domain& domain,
                const Options& options);

  FeatureSearch(const FeatureSearch&) = delete;
  FeatureSearch& operator=(const FeatureSearch&) = delete;
  ~FeatureSearch() = default;

  /// The contacts among the candidates. `find(candidates, found)` is called once for each sphere
  /// that has some and appends its contacts; `measure` is a FeatureMeasurer or a BoxMeasurer.
  /// Workers call both at the same time.
  template <class Contact, class Find, class Measure>
  [[nodiscard]] ContactList<Contact> contacts(Find&& find, const Measure& measure) {
    return base::letting_through([&] {
      return base::reporting_lack_of_memory(memory_, [&] {
        context_.progress.begin("features", candidates_.size());
        std::vector<FoundContacts<Contact>> found(workers_, FoundContacts<Contact>(memory_));
        find_each(found, find);
        return joined(found, measure);
      });
    });
  }

 private:
  /// Cost of one exact decision, in steps through an array.
  static constexpr std::uint64_t steps_of_decision = 64;

  /// Calls `find` for the spheres of each worker's share.
  template <class Contact, class Find>
  void find_each(std::vector<FoundContacts<Contact>>& found, Find& find) {
    base::for_each_share(workers_, context_.work, [&](std::size_t share, base::WorkCounter& work) {
      const auto [first, last] = share_of(share);
      for (std::size_t place = first; place < last;) {
        const std::size_t end = end_of_sphere(place);
        find(candidates_between(place, end), found[share]);
        context_.progress.advance(end - place);
        work.did(steps_of_decision * (end - place));
        place = end;
      }
    });
  }

  void gather(const ElementView& spheres);
  void keep_all();
  void leave_out_far(const ElementView& boxes, const Domain& domain);
  [[nodiscard]] base::Array<exact::Box<Dim>> boxes_around();
  [[nodiscard]] Options options_of_search(const Domain& domain) const;
  void find_candidates(const ElementView& boxes, const Domain& domain);
  void order_candidates(lists::FoundPairs& found);

  /// The place behind `place` where the candidates of another sphere begin.
  [[nodiscard]] std::size_t end_of_sphere(std::size_t place) const;

  /// The candidates of a worker, by places; those of one sphere are one worker's.
  [[nodiscard]] std::pair<std::size_t, std::size_t> share_of(std::size_t worker) const;

  /// All candidates of one sphere, which lie in places [place, end).
  [[nodiscard]] SphereCandidates<Dim> candidates_between(std::size_t place, std::size_t end) const {
    const auto pairs = std::span<const ContactPair>(candidates_).subspan(place, end - place);
    const std::span<const ImageShift> shifts(shifts_);
    const ElementIndex number = near_[pairs.front().first];
    return {number, spheres_[number], pairs,
            shifts.empty() ? shifts : shifts.subspan(place, end - place)};
  }

  template <class Contact, class Measure>
  [[nodiscard]] ContactList<Contact> joined(const std::vector<FoundContacts<Contact>>& found,
                                            const Measure& measure) {
    Statistics statistics = statistics_;
    count(found, statistics);
    require_allowed(statistics.contact_pairs, options_);
    // Given back with the meter itself: the list is the caller's from then on.
    const bool with_shifts = options_.shifts == Shifts::stored || !options_.quantities.empty();
    const std::size_t shift_count = with_shifts ? statistics.contact_pairs : 0;
    memory_.take_for_pairs(statistics.contact_pairs * sizeof(Contact) +
                           shift_count * sizeof(ImageShift));
    std::vector<Contact> all;
    std::vector<ImageShift> shifts;
    all.reserve(statistics.contact_pairs);
    shifts.reserve(shift_count);
    for (const auto& part : found) {
      for (const ImageContact<Contact>& one : part.contacts) {
        context_.work.did(1);
        all.push_back(one.contact);
        if (with_shifts) shifts.push_back(one.shift);
      }
    }
    PairGeometry geometry;
    measure_all(all, shifts, measure, geometry, statistics);
    if (options_.shifts == Shifts::none) shifts = {};
    statistics.list_insertions = context_.list_insertions;
    statistics.peak_bytes = memory_.peak();
    statistics.working_bytes = memory_.working_peak();
    return ContactList<Contact>(std::move(all), std::move(shifts), std::move(geometry), statistics);
  }

  template <class Contact>
  void count(const std::vector<FoundContacts<Contact>>& found, Statistics& statistics) const {
    statistics.elements = elements_;
    statistics.candidate_tests = candidates_.size();
    statistics.exact_decisions = statistics.contact_pairs = 0;
    for (const auto& part : found) {
      statistics.exact_decisions += part.exact_decisions;
      statistics.contact_pairs += part.contacts.size();
    }
  }

  template <class Contact, class Measure>
  void measure_all(const std::vector<Contact>& contacts, const std::vector<ImageShift>& shifts,
                   const Measure& measure, PairGeometry& geometry, Statistics& statistics) {
    if (options_.quantities.empty()) return;
    base::Stopwatch stopwatch;
    const lists::SizedGeometry sized(geometry, options_.quantities, contacts.size(), memory_);
    context_.progress.begin("measure", contacts.size());
    const auto sphere_of = [&](ElementIndex number) { return spheres_[number]; };
    const WallContacts<Measure, Contact> given{measure, contacts, shifts, workers_,
                                               kernels::level_to_run(options_.simd)};
    measure_contacts(given, geometry.spans(), context_.work, sphere_of);
    statistics.measure_seconds = stopwatch.lap();
  }

  const Options& options_;
  std::size_t elements_;  ///< of both
  std::size_t workers_;
  base::MemoryMeter memory_;
  base::DetectionContext context_;
  base::Array<exact::Sphere<Dim>> spheres_;
  base::Array<ElementIndex> near_;       ///< numbers of the spheres that are searched, ascending
  base::Array<ContactPair> candidates_;  ///< (place in near_, box), ascending
  base::Array<ImageShift> shifts_;       ///< of the candidates; none in open space
  Statistics statistics_;                ///< of the search for candidates
};

}  // namespace abut::walls
