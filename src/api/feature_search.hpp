#pragma once

#include "api/lack_of_memory.hpp"
#include "base/array.hpp"
#include "base/box.hpp"
#include "base/memory_meter.hpp"
#include "base/sphere_predicate.hpp"
#include "base/workers.hpp"

#include <abut/contact_list.hpp>
#include <abut/element_view.hpp>
#include <abut/options.hpp>
#include <abut/pair_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace abut::api {

/// A box around all that lies within radius + margin of the center; what is beyond the largest
/// double is left out.
template <int Dim>
[[nodiscard]] base::Box<Dim> box_around(const base::Sphere<Dim>& sphere, double margin) noexcept;

/// Throws Error{limit_exceeded} for more contacts than the options allow.
void require_allowed(PairCount contacts, const Options& options);

/// Contacts that one worker found, in ascending order.
template <class Contact>
struct alignas(128) FoundContacts {
  base::Array<Contact> contacts;
  std::uint64_t exact_decisions = 0;
};

/// A sphere and the boxes around something else that the box around it meets.
template <int Dim>
struct Candidates {
  ElementIndex number;
  const base::Sphere<Dim>& sphere;
  std::span<const ContactPair> pairs;  ///< `second` are the others, ascending
};

/// Spheres, and which of them have a box around them that meets a box around something else: what
/// a search for contacts with features begins with.
template <int Dim>
class FeatureSearch {
 public:
  /// Throws as a detection of two sets does. `options` must outlive it.
  FeatureSearch(const ElementView& spheres, const ElementView& boxes, const Options& options);

  FeatureSearch(const FeatureSearch&) = delete;
  FeatureSearch& operator=(const FeatureSearch&) = delete;

  /// The contacts among the candidates. `find(candidates, found)` is called once for each sphere
  /// that has some and appends its contacts; workers call it at the same time.
  template <class Contact, class Find>
  [[nodiscard]] ContactList<Contact> contacts(Find&& find) {
    return reporting_lack_of_memory(memory_, [&] {
      std::vector<FoundContacts<Contact>> found(
          workers_, {base::make_array_for_overwrite<Contact>(memory_, 0), 0});
      base::for_each_worker(workers_, [&](std::size_t worker) {
        for (auto rest = share_of(worker); !rest.empty();) {
          const auto pairs = rest.first(end_of_sphere(rest, 0));
          const ElementIndex number = near_[pairs.front().first];
          find(Candidates<Dim>{number, spheres_[number], pairs}, found[worker]);
          rest = rest.subspan(pairs.size());
        }
      });
      return joined(found);
    });
  }

 private:
  void gather(const ElementView& spheres);
  void leave_out_far(const ElementView& boxes);
  [[nodiscard]] base::Array<base::Box<Dim>> boxes_around();
  [[nodiscard]] Options options_of_search() const;

  /// The place behind `place` where the candidates of another sphere begin.
  [[nodiscard]] static std::size_t end_of_sphere(std::span<const ContactPair> pairs,
                                                 std::size_t place);

  /// The candidates of a worker; those of one sphere are one worker's.
  [[nodiscard]] std::span<const ContactPair> share_of(std::size_t worker) const;

  template <class Contact>
  [[nodiscard]] ContactList<Contact> joined(const std::vector<FoundContacts<Contact>>& found) {
    Statistics statistics = candidates_.statistics();
    statistics.elements = elements_;
    statistics.candidate_tests = candidates_.size();
    statistics.exact_decisions = statistics.contact_pairs = 0;
    for (const auto& part : found) {
      statistics.exact_decisions += part.exact_decisions;
      statistics.contact_pairs += part.contacts.size();
    }
    require_allowed(statistics.contact_pairs, options_);
    // Given back with the meter itself: the list is the caller's from then on.
    memory_.take_for_pairs(statistics.contact_pairs * sizeof(Contact));
    std::vector<Contact> all;
    all.reserve(statistics.contact_pairs);
    for (const auto& part : found) {
      all.insert(all.end(), part.contacts.begin(), part.contacts.end());
    }
    statistics.peak_bytes = std::max(peak_of_search_, memory_.peak());
    return ContactList<Contact>(std::move(all), statistics);
  }

  const Options& options_;
  std::size_t elements_;  ///< of both
  std::size_t workers_;
  base::MemoryMeter memory_;
  base::Array<base::Sphere<Dim>> spheres_;
  base::Array<ElementIndex> near_;  ///< numbers of the spheres that are searched, ascending
  PairList candidates_;             ///< (place in near_, box), ascending
  std::uint64_t peak_of_search_ = 0;
};

}  // namespace abut::api
