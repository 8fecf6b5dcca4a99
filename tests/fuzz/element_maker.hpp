#pragma once

#include "fuzz/domain_maker.hpp"
#include "fuzz/fuzz_case.hpp"

#include <array>

namespace abut::fuzz {

/// Places elements: anywhere, upon each other, touching each other or an image, and moves them.
class ElementMaker {
 public:
  ElementMaker(ByteReader& reader, NumberMaker& numbers, const DomainMaker& domain, double margin)
      : reader_(reader), numbers_(numbers), domain_(domain), margin_(margin) {}

  /// Adds one element. Its radius is `common_radius` where that is not negative; what is placed
  /// without looking at the others lies within `expanse` times as much.
  void add(ElementArrays& elements, double common_radius, double expanse);

  /// Moves some elements a little, by lattice vectors or to anywhere.
  void move(ElementArrays& elements);

 private:
  void place_beside(ElementArrays& elements, std::size_t other);
  void shift(ElementArrays& elements, std::size_t k, std::size_t axis, double way);

  ByteReader& reader_;
  NumberMaker& numbers_;
  const DomainMaker& domain_;
  double margin_;
};

/// Element `k` is taken away; the last one takes its number.
void remove_element(ElementArrays& elements, std::size_t k);

}  // namespace abut::fuzz
