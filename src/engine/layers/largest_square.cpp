#include "engine/layers/largest_square.hpp"

#include "exact/numbers/big_integer.hpp"
#include "exact/numbers/bit_range.hpp"

namespace abut::engine {

std::int32_t largest_square_within(double diameter, double margin, double step,
                                   double units) noexcept {
  exact::BitRange bits;
  for (const double number : {diameter, margin, step}) bits.include(number);
  const auto whole = [&](double number) { return exact::BigInteger(number, bits.lowest()); };
  const exact::BigInteger side = whole(step);
  const exact::BigInteger square_of_step = side * side;
  const exact::BigInteger reach = exact::BigInteger(units, 0) * (whole(diameter) + whole(margin));
  const exact::BigInteger square_of_reach = reach * reach;
  const auto is_within = [&](std::int32_t square) {
    return exact::BigInteger(static_cast<double>(square), 0) * square_of_step <= square_of_reach;
  };
  // Below 2^30, known to a small part of 1: one step or none.
  const double rounded = units / step * (diameter + margin);
  auto square = static_cast<std::int32_t>(rounded * rounded);
  while (!is_within(square)) --square;
  while (is_within(square + 1)) ++square;
  return square;
}

}  // namespace abut::engine
