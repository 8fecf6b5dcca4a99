#include "io/quoted_text.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace abut::io {
namespace {

TEST(VisibleText, PrintableTextStaysAsItIs) {
  for (const std::string text : {"", "plain name.csv", "caf\xC3\xA9", "\xE6\xBC\xA2\xE5\xAD\x97",
                                 "\xF0\x9F\x99\x82", "a\\b'c\"d", "\xD0\x96", "\xEF\xBF\xBD"}) {
    EXPECT_EQ(visible(text), text);
  }
}

TEST(VisibleText, WhatATerminalObeysBecomesAnEscape) {
  const auto expect = [](const std::string& text, const std::string& shown) {
    EXPECT_EQ(visible(text), shown);
    EXPECT_EQ(visible(shown), shown) << "twice is once";
  };
  expect("a\nabut: b", "a\\x0aabut: b");
  expect("\r\t\x1b[31m\x7f", "\\x0d\\x09\\x1b[31m\\x7f");
  expect(std::string("\0", 1), "\\x00");
  expect(
      "\xC2\x9B"
      "31m",
      "\\u{009b}31m");  // a control of 8 bits, as UTF-8
  expect(
      "\x9B"
      "31m",
      "\\x9b31m");  // and as one byte
  expect(
      "\xE2\x80\xAE"
      "cba",
      "\\u{202e}cba");                  // from right to left
  expect("\xE2\x81\xA6", "\\u{2066}");  // an isolate
  expect("\xE2\x80\x8B", "\\u{200b}");  // no width
  expect("\xE2\x80\xA8", "\\u{2028}");  // end of a line
  expect(
      "\xEF\xBB\xBF"
      "x",
      "\\u{feff}x");                         // a byte order mark
  expect("\xF3\xA0\x81\xA1", "\\u{e0061}");  // a tag
}

TEST(VisibleText, BytesThatAreNoUtf8) {
  EXPECT_EQ(visible("\xFF"), "\\xff");
  EXPECT_EQ(visible("\xC3"), "\\xc3") << "cut off";
  EXPECT_EQ(visible("\xC0\xAF"), "\\xc0\\xaf") << "longer than needed";
  EXPECT_EQ(visible("\xE0\x80\xAF"), "\\xe0\\x80\\xaf");
  EXPECT_EQ(visible("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
  EXPECT_EQ(visible("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
  EXPECT_EQ(visible("\xF0\x9F\x99z"), "\\xf0\\x9f\\x99z");
}

TEST(VisibleText, OfLongTextBothEndsAreKept) {
  const std::string text = "begin" + std::string(5000, 'x') + "end";
  const std::string shown = visible(text, 100);
  EXPECT_EQ(shown.size(), 100u);
  EXPECT_TRUE(shown.starts_with("beginxxx") && shown.ends_with("xxxend")) << shown;
  EXPECT_NE(shown.find("x...x"), std::string::npos);
  EXPECT_EQ(visible(shown, 100), shown);
  EXPECT_LE(visible(std::string(5000, '\n'), 100).size(), 100u);
  EXPECT_EQ(visible(std::string(100, 'x'), 100), std::string(100, 'x'));
}

TEST(QuotedText, IsShort) {
  EXPECT_EQ(io::quoted("abc"), "'abc'");
  EXPECT_EQ(io::quoted(std::string(40, 'q')), "'" + std::string(40, 'q') + "'");
  EXPECT_EQ(io::quoted(std::string(41, 'q')), "'" + std::string(40, 'q') + "...'");
  std::string umlauts;
  for (int k = 0; k < 40; ++k) umlauts += "\xC3\xA4";
  EXPECT_EQ(io::quoted(umlauts), "'" + umlauts + "'");
  EXPECT_EQ(io::quoted(umlauts + "o"), "'" + umlauts + "...'") << "no character is cut in two";
}

/// All bytes of a text are taken once, and what is shown is UTF-8 that shows.
TEST(VisibleText, RandomBytes) {
  scenes::Random random(5);
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    const std::size_t size = random.below(12);
    for (std::size_t k = 0; k < size; ++k) text += static_cast<char>(random.next());
    std::size_t taken = 0;
    for (std::string_view rest = text; !rest.empty();) {
      const Character character = first_character(rest);
      ASSERT_LE(character.bytes, rest.size());
      ASSERT_TRUE(character.is_utf8 || (character.bytes == 1 && !character.is_visible));
      taken += character.bytes;
      rest.remove_prefix(character.bytes);
    }
    ASSERT_EQ(taken, text.size());
    const std::string shown = visible(text);
    for (std::string_view rest = shown; !rest.empty();) {
      ASSERT_TRUE(first_character(rest).is_visible) << shown;
      rest.remove_prefix(first_character(rest).bytes);
    }
    ASSERT_EQ(visible(shown), shown);
  }
}

}  // namespace
}  // namespace abut::io
