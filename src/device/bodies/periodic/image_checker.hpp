#pragma once

#include "base/host_device.hpp"
#include "device/bodies/element_pairs.hpp"
#include "device/bodies/filter.hpp"
#include "device/bodies/last_at.hpp"
#include "device/bodies/partners.hpp"
#include "device/bodies/periodic/window_images.hpp"
#include "lattice/image_window.hpp"

#include <abut/pair.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::device {

/// Images of a pair that are looked at by one item.
inline constexpr std::uint64_t images_of_item = 32;

/// Pairs of elements and the images of the second of each that may be within reach of the first
/// (lattice::ImageWindows): some images of one pair are an item. `Spheres` is CheckedElements.
template <class Spheres>
struct ImageChecker {
  static constexpr int Dim = Spheres::dimensions;
  using Numbers = lattice::ImageNumbers;
  using Image = typename Spheres::Ghost;

  Spheres elements;
  lattice::ImageWindows<Dim> windows;
  double margin;
  std::uint64_t first_pair;  ///< of those that are looked at
  std::uint64_t pairs;
  const std::uint64_t* items_before;  ///< of each of them

  [[nodiscard]] ABUT_HD std::uint64_t items_of(std::uint64_t k) const noexcept {
    return (images_of(pair_at(k)).count + images_of_item - 1) / images_of_item;
  }

  template <class Sink>
  ABUT_HD void partners_of(std::uint64_t item, Sink& sink) const noexcept {
    const std::uint64_t k = number_of_pair(item);
    const ContactPair pair = pair_at(k);
    const WindowImages images = images_of(pair);
    const std::uint64_t first = (item - items_before[k]) * images_of_item;
    const auto a = elements.whole(pair.first);
    const auto b = elements.whole(pair.second);
    Numbers numbers = images.at(first);
    for (std::uint64_t left = images.in_item(first, images_of_item); left > 0; --left) {
      const FilterVerdict verdict = verdict_of(pair, numbers, a, b, images.shifts_fit);
      if (verdict != FilterVerdict::apart) {
        sink.take(pair.first, Image{pair.second, numbers}, verdict);
      }
      images.advance(numbers);
    }
  }

  /// How many distances an item compares.
  [[nodiscard]] ABUT_HD std::uint64_t tests_of(std::uint64_t item) const noexcept {
    const std::uint64_t k = number_of_pair(item);
    return images_of(pair_at(k)).in_item((item - items_before[k]) * images_of_item, images_of_item);
  }

  [[nodiscard]] ABUT_HD WindowSize size_of(std::uint64_t k) const noexcept {
    const ContactPair pair = pair_at(k);
    return size_of_window(window_of(pair));
  }

 private:
  [[nodiscard]] ABUT_HD ContactPair pair_at(std::uint64_t k) const noexcept {
    return ElementPairs{elements.count}.at(first_pair + k);
  }

  [[nodiscard]] ABUT_HD lattice::ImageWindow window_of(const ContactPair& pair) const noexcept {
    return windows.of(elements.whole(pair.first), elements.whole(pair.second), margin);
  }

  /// None of a pair that may not be one, unless a shift may be too large, which is refused in any
  /// case.
  [[nodiscard]] ABUT_HD WindowImages images_of(const ContactPair& pair) const noexcept {
    WindowImages images(window_of(pair), pair.first == pair.second, elements.map.shift_of_side);
    if (images.shifts_fit && !elements.may_pair(pair)) images.count = 0;
    return images;
  }

  /// The last pair whose items begin at or before this one.
  [[nodiscard]] ABUT_HD std::uint64_t number_of_pair(std::uint64_t item) const noexcept {
    return last_at(items_before, pairs, item);
  }

  /// The second element of a pair as it is, or as an image of it: its place is off by less than
  /// half of the slack (docs/derivations/whole_numbers.md, section 10).
  template <class Element>
  [[nodiscard]] ABUT_HD FilterVerdict verdict_of(const ContactPair& pair, const Numbers& numbers,
                                                 const Element& a, const Element& b,
                                                 bool shifts_fit) const noexcept {
    const bool is_itself = numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 0;
    if (is_itself && !elements.may_pair(pair)) return FilterVerdict::apart;
    if (is_itself) return filter(a, b, margin, 0.0);
    MovedBy<Dim> moved(elements.map.steps, numbers);
    const Element image = moved.of(b);
    const FilterVerdict verdict = filter(a, image, margin, moved.slack());
    if (verdict == FilterVerdict::apart || shifts_fit) return verdict;
    return FilterVerdict::doubtful;
  }
};

/// Body of a reduction: how many images pair k has.
template <class Search>
struct WindowSizeOf {
  Search search;

  [[nodiscard]] ABUT_HD WindowSize operator()(std::uint64_t k) const noexcept {
    return search.size_of(k);
  }
};

/// Writes pairs, and beside them the images that their second elements are. One that is the element
/// itself is no image.
template <class Image>
struct ImagePairWriter {
  ContactPair* certain;   ///< next place; null where certain pairs are only counted
  ContactPair* doubtful;  ///< next place
  const ContactPair* first_place;
  Image* images;  ///< one for each place
  std::uint32_t elements;

  ABUT_HD void take(std::uint32_t one, const Image& other, FilterVerdict verdict) noexcept {
    ContactPair* place = doubtful;
    if (verdict == FilterVerdict::doubtful) {
      ++doubtful;
    } else if (certain != nullptr) {
      place = certain++;
    } else {
      return;
    }
    const bool is_itself = other.image[0] == 0 && other.image[1] == 0 && other.image[2] == 0;
    const auto number = static_cast<std::uint32_t>(place - first_place);
    const auto element = static_cast<std::uint32_t>(other.element);
    *place = {one, is_itself ? element : elements + number};
    images[number] = other;
  }
};

/// Body: writes the partners of item k and their images.
template <class Search>
struct FillImages {
  using Image = typename Search::Image;

  FillPartners<Search> fill;
  const ContactPair* first_place;
  Image* images;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const PartnerWriter places = fill.writer(k);
    ImagePairWriter<Image> writer{places.certain, places.doubtful, first_place, images,
                                  fill.search.elements.count};
    fill.search.partners_of(fill.first_item + k, writer);
  }
};

}  // namespace abut::device
