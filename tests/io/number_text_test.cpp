#include "io/number_text.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace abut::io {
namespace {

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

double parsed(std::string_view text) {
  const auto [value, fault] = parse_number(text);
  EXPECT_EQ(fault, NumberFault::none) << text;
  return value;
}

TEST(ParseNumber, DecimalTexts) {
  EXPECT_EQ(parsed("1"), 1.0);
  EXPECT_EQ(parsed("+1"), 1.0);
  EXPECT_EQ(parsed("-.5"), -0.5);
  EXPECT_EQ(parsed("5."), 5.0);
  EXPECT_EQ(parsed("1E+3"), 1000.0);
  EXPECT_EQ(parsed("+1e-3"), 0.001);
  EXPECT_EQ(parsed("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parsed("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(bits(parsed("-0")), bits(-0.0));
  EXPECT_EQ(parsed(std::string(1000, '0') + "7"), 7.0);
}

/// Rounded as the nearest double says: far beyond what the first 17 digits decide.
TEST(ParseNumber, HalfwayCases) {
  EXPECT_EQ(parsed("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(parsed("9007199254740993." + std::string(500, '0') + "1"), 9007199254740994.0);
  EXPECT_EQ(parsed("1.00000000000000011102230246251565"), 1.0);
  EXPECT_EQ(parsed("1.000000000000000111022302462515655"), 1.0000000000000002);
}

TEST(ParseNumber, TooSmallForADoubleIsZero) {
  for (const std::string& text :
       {std::string("1e-999"), std::string("1e-400"), "0." + std::string(500, '0') + "1",
        "0." + std::string(800, '0') + "1e400", std::string("+12345e-99999999999999999999")}) {
    EXPECT_EQ(bits(parsed(text)), bits(0.0)) << text;
  }
  EXPECT_EQ(bits(parsed("-1e-999")), bits(-0.0));
  EXPECT_EQ(parsed("0e999999999999999999999"), 0.0);
}

TEST(ParseNumber, Faults) {
  for (const char* text :
       {"",   " ",   "+",  "-",   ".",    "e5", "--1",  "+-1", "-+1",   "++1", "1 ",
        " 1", "1,5", "1e", "1e+", "0x10", "1f", "1..2", "one", "1_000", "1d5"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::not_a_number) << text;
  }
  for (const char* text : {"nan", "NaN", "-nan", "inf", "-inf", "+inf", "Infinity"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::not_finite) << text;
  }
  for (const std::string& text :
       {std::string("1e309"), std::string("-1e999"), std::string("1.8e308"), std::string(310, '9'),
        "0.0001e" + std::string(30, '9'), "1" + std::string(700, '0') + "e-300"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::too_large) << text;
  }
}

TEST(ParseNumber, RandomBitsSurviveSeventeenDigits) {
  scenes::Random random(20);
  for (int k = 0; k < 20000; ++k) {
    const double value = std::bit_cast<double>(random.next());
    if (!std::isfinite(value)) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    EXPECT_EQ(bits(parsed(text)), bits(value)) << text;
  }
}

TEST(ParseInteger, WholeNumbersOf64Bits) {
  EXPECT_EQ(parse_integer("-9223372036854775808"), INT64_MIN);
  EXPECT_EQ(parse_integer("+7"), 7);
  for (const char* text : {"", "+", "9223372036854775808", "1.0", "1e3", "0x1", " 1", "+-1"}) {
    EXPECT_EQ(parse_integer(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace abut::io
