#include "fuzz/number_maker.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace abut::fuzz {
namespace {

constexpr std::array<int, 16> extreme_exponents{-1074, -1070, -1022, -960, -931, -600, -480, -400,
                                                400,   480,   500,   900,  930,  990,  1010, 1017};

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr std::array<double, 8> extremes{-0.0,  smallest, -smallest, 0x1p-1022,
                                         1e300, -1e300,   largest,   -largest};

/// Nearly always 1, for ties are found best there.
int exponent_of_unit(ByteReader& reader) {
  const std::size_t kind = reader.byte();
  if (kind < 176) return 0;
  if (kind < 216) return reader.signed_byte() / 4;
  if (kind < 240) return extreme_exponents[reader.below(extreme_exponents.size())];
  return 8 * reader.signed_byte();
}

}  // namespace

NumberMaker::NumberMaker(ByteReader& reader, Precision precision)
    : reader_(reader), precision_(precision) {
  int exponent = exponent_of_unit(reader);
  if (precision == Precision::float32) exponent = std::clamp(exponent, -149, 122);
  unit_ = std::ldexp(1.0, exponent);
  const unsigned first = reader.byte();
  spice_ = first & reader.byte();
}

double NumberMaker::fitted(double value) const {
  if (std::isnan(value)) return 0.0;
  if (precision_ == Precision::float64) return std::clamp(value, -largest, largest);
  constexpr double largest_float = std::numeric_limits<float>::max();
  return static_cast<double>(static_cast<float>(std::clamp(value, -largest_float, largest_float)));
}

double NumberMaker::number() {
  const std::size_t kind = reader_.byte();
  const double plain = unit_ * (static_cast<int>(kind / 8) - 16);
  if (kind % 8 != 7) return fitted(plain);
  return fitted(exotic(plain));
}

double NumberMaker::exotic(double plain) {
  const std::size_t kind = reader_.below(8);
  if ((spice_ >> kind & 1U) == 0) return plain + unit_ * reader_.signed_byte();
  switch (kind) {
    case 0:
      return plain + unit_ * reader_.signed_byte() / 64.0;
    case 1:
      return nudged(plain);
    case 2:
      return std::bit_cast<double>(reader_.word());
    case 3:
      return plain + std::ldexp(unit_, reader_.byte() / 2);
    case 4:
      return extremes[reader_.below(extremes.size())];
    case 5:
      return plain / 3.0;
    case 6:
      return plain + std::ldexp(1.0, 8 * reader_.signed_byte());
    default:
      return plain * 0.1 + 1e-9 * unit_ * reader_.signed_byte();
  }
}

double NumberMaker::size() {
  return std::fabs(number());
}

double NumberMaker::nudged(double value) {
  const std::size_t way = reader_.below(3);
  if (way == 0) return value;
  if (precision_ == Precision::float64) {
    return fitted(std::nextafter(value, way == 1 ? largest : -largest));
  }
  const float infinite = std::numeric_limits<float>::infinity();
  return fitted(static_cast<double>(
      std::nextafter(static_cast<float>(fitted(value)), way == 1 ? infinite : -infinite)));
}

}  // namespace abut::fuzz
