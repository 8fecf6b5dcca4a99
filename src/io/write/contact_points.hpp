#pragma once

#include "io/write/contact_writer.hpp"

#include <abut/domain.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::io {

/// An element of one of the sets.
struct PlacedElement {
  const Snapshot& snapshot;
  std::size_t number;

  [[nodiscard]] std::array<double, 3> position() const {
    return {snapshot.x[number], snapshot.y[number],
            snapshot.dimensions == 2 ? 0.0 : snapshot.z[number]};
  }
};

/// The points of the picture: the elements of the first set, those of the second, then a point for
/// each line that ends in an image of an element.
class ContactPoints {
 public:
  explicit ContactPoints(const ContactWriter& writer)
      : writer_(writer), elements_(writer.elements()) {
    if (!writer.is_periodic()) return;
    for (std::uint64_t k = 0; k < writer.pairs().size(); ++k) {
      if (writer.shift(k) != ImageShift{}) pairs_with_image_.push_back(k);
    }
  }

  [[nodiscard]] std::uint64_t size() const { return elements_.size() + pairs_with_image_.size(); }
  [[nodiscard]] std::uint64_t first_image() const { return elements_.size(); }
  [[nodiscard]] bool have_sets() const { return elements_.are_of_two_sets(); }
  [[nodiscard]] bool have_ids() const {
    return elements_.size() > 0 && elements_.first.ids.size() == elements_.first.size() &&
           elements_.partners().ids.size() == elements_.partners().size();
  }

  /// The point of element j of a pair.
  [[nodiscard]] std::uint64_t of_partner(ElementIndex j) const {
    return have_sets() ? elements_.first.size() + j : j;
  }
  /// The point of an element: of an image, that of the element itself.
  [[nodiscard]] std::uint64_t original(std::uint64_t point) const {
    return point < first_image() ? point : of_partner(writer_.pairs()[pair_of_image(point)].second);
  }
  [[nodiscard]] std::int32_t set_of(std::uint64_t point) const {
    return original(point) < elements_.first.size() ? 0 : 1;
  }
  [[nodiscard]] PlacedElement element(std::uint64_t point) const {
    const std::uint64_t place = original(point);
    const std::size_t firsts = elements_.first.size();
    return place < firsts ? PlacedElement{elements_.first, place}
                          : PlacedElement{elements_.partners(), place - firsts};
  }

  /// Position of a point, of an image rounded, for pictures.
  [[nodiscard]] std::array<double, 3> position(std::uint64_t point) const {
    std::array<double, 3> position = element(point).position();
    if (point < first_image()) return position;
    const ImageShift shift = writer_.shift(pair_of_image(point));
    const std::array<std::int32_t, 3> numbers{shift.x, shift.y, shift.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int k = 0; k < 3; ++k) {
        const Domain::Vector& vector = writer_.domain().vector(k);
        position[axis] += numbers[static_cast<std::size_t>(k)] * vector[axis];
      }
    }
    return position;
  }

 private:
  [[nodiscard]] std::uint64_t pair_of_image(std::uint64_t point) const {
    return pairs_with_image_[point - first_image()];
  }

  const ContactWriter& writer_;
  const ContactElements& elements_;
  std::vector<std::uint64_t> pairs_with_image_;
};

}  // namespace abut::io
