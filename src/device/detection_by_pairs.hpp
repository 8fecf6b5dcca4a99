#pragma once

#include "device/bodies/cross_level.hpp"
#include "device/bodies/element_pairs.hpp"
#include "device/bodies/periodic/image_checker.hpp"
#include "device/device_request.hpp"
#include "device/executor.hpp"
#include "device/found_list.hpp"
#include "device/pair_decision.hpp"
#include "device/search/part_sums.hpp"
#include "device/search/partner_search.hpp"
#include "lattice/check_range.hpp"
#include "lattice/ghost_windows.hpp"
#include "lattice/image_window.hpp"

#include <algorithm>
#include <cstdint>

namespace abut::device {

/// Looks at all images of all elements that a window of two of them does not exclude, pair by pair:
/// where the reach is as long as the cell no grid would help. `Spheres` is CheckedElements, of
/// which images are written behind the search.
template <class Spheres, class E>
class ImageSearchByPairs {
  static constexpr int Dim = Spheres::dimensions;

 public:
  using Windows = lattice::ImageWindows<Dim>;

  /// `margin` is in the unit of the elements. Throws Error{limit_exceeded} as soon as there are
  /// more pairs than may be.
  ImageSearchByPairs(E& executor, const Spheres& elements, const Windows& windows, double margin,
                     const DeviceRequest& request)
      : executor_(executor),
        elements_(elements),
        windows_(windows),
        margin_(margin),
        items_at_a_time_(request.items_at_a_time),
        sums_(executor) {
    for_each_part([&](Search& search, std::uint64_t part) {
      // Waits for each part: a limit is met as soon as it is passed.
      search.count(part, sums_.next());
      sums_.collect();
      totals_.add(sums_.on_host().back());
      require_count(totals_.certain, request.max_pairs);
    });
  }

  [[nodiscard]] const PartnerCount& totals() const noexcept { return totals_; }
  [[nodiscard]] const Spheres& elements() const noexcept { return elements_; }

  /// Writes totals().certain pairs, unless `certain` is null, and totals().doubtful pairs behind
  /// them.
  void write(ContactPair* certain, ContactPair* doubtful) {
    const ContactPair* const first_place = certain == nullptr ? doubtful : certain;
    const std::uint64_t places = totals_.doubtful + (certain == nullptr ? 0 : totals_.certain);
    if (static_cast<double>(elements_.count) + static_cast<double>(places) >
        lattice::most_locals_and_ghosts) {
      lattice::refuse_number_of_images();
    }
    images_ = Buffer<Image, E>(executor_, places);
    elements_.ghosts = {images_.data()};
    auto sums = sums_.on_host().begin();
    for_each_part([&](Search& search, std::uint64_t part) {
      search.write_by(part, certain, doubtful, [&](const FillPartners<Check>& fill) {
        return FillImages<Check>{fill, first_place, images_.data()};
      });
      if (certain != nullptr) certain += sums->certain;
      doubtful += sums->doubtful;
      ++sums;
    });
  }

 private:
  using Check = ImageChecker<Spheres>;
  using Search = PartnerSearch<Check, E>;
  using Image = typename Spheres::Ghost;

  /// Calls use(search, part) for the parts of searches of some pairs each. Their images are counted
  /// anew each time, so that memory does not follow the pairs that are looked at.
  template <class Use>
  void for_each_part(const Use& use) {
    const std::uint64_t pairs = ElementPairs{elements_.count}.size();
    const std::uint64_t most = std::min(pairs, items_at_a_time_);
    for (std::uint64_t first = 0; first < pairs; first += most) {
      const std::uint64_t count = std::min(most, pairs - first);
      Buffer<std::uint64_t, E> items(executor_, count + 1);
      const Check check{elements_, windows_, margin_, first, count, items.data()};
      require_windows(check, count);
      executor_.for_each(count + 1, CountItems<Check>{check, count, items.data()});
      const std::uint64_t all = sum_before_each(executor_, items.data(), count);
      Search search(executor_, check, 0, all, items_at_a_time_);
      for (std::uint64_t part = 0; part < search.part_count(); ++part) use(search, part);
    }
  }

  /// Waits: what cannot be told apart, or numbered, is refused before anything is stored.
  void require_windows(const Check& check, std::uint64_t count) {
    const WindowSize widest =
        executor_.reduce(count, WindowSize{}, WindowSizeOf<Check>{check}, JoinWindowSizes{});
    lattice::require_narrow_window(widest.farthest);
    if (widest.images > lattice::most_locals_and_ghosts) lattice::refuse_number_of_images();
  }

  E& executor_;
  Spheres elements_;
  Windows windows_;
  double margin_;
  std::uint64_t items_at_a_time_;
  PartSums<E> sums_;
  Buffer<Image, E> images_;
  PartnerCount totals_;
};

/// What Detection does, pair by pair.
template <class Spheres, class E>
class DetectionByPairs {
 public:
  using Search = ImageSearchByPairs<Spheres, E>;

  DetectionByPairs(E& executor, const Spheres& elements, const typename Search::Windows& windows,
                   double margin, const DeviceRequest& request)
      : search_(executor, elements, windows, margin, request), decision_(executor, request) {}

  /// All contact pairs, in no order.
  void list(FoundList<E>& found) {
    found.searched = spheres().elements.count;
    decision_.list(search_, found);
  }

  /// Their number. Only pairs in doubt take memory.
  void count(FoundList<E>& found) {
    found.searched = spheres().elements.count;
    decision_.count(search_, found);
  }

  /// In which the numbers of pairs are told.
  [[nodiscard]] const Spheres& spheres() const noexcept { return search_.elements(); }

 private:
  Search search_;
  PairDecision<E> decision_;
};

}  // namespace abut::device
