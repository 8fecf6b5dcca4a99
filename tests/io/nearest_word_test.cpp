#include "io/nearest_word.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace abut::io {
namespace {

const std::vector<std::string> options{"--count",     "--digest",     "--cutoff",
                                       "--max-pairs", "--max-memory", "-o"};

TEST(NearestWord, ForgivesOneLetterInThree) {
  EXPECT_EQ(nearest_word("--cout", options), "--count");     // left out
  EXPECT_EQ(nearest_word("--countt", options), "--count");   // put in
  EXPECT_EQ(nearest_word("--vutoff", options), "--cutoff");  // changed
  EXPECT_EQ(nearest_word("--digset", options), "--digest");  // exchanged
  EXPECT_EQ(nearest_word("--maxpairs", options), "--max-pairs");
  EXPECT_EQ(nearest_word("--max_memory", options), "--max-memory");
}

TEST(NearestWord, OfABeginningIsTheOnlyWordThatBeginsSo) {
  EXPECT_EQ(nearest_word("--dig", options), "--digest");
  EXPECT_EQ(nearest_word("--max-m", options), "--max-memory");
  EXPECT_EQ(nearest_word("--max-", options), "");
}

TEST(NearestWord, IsEmptyWhereNoneIsNear) {
  EXPECT_EQ(nearest_word("--cube", options), "");
  EXPECT_EQ(nearest_word("", options), "");
  EXPECT_EQ(nearest_word("x", options), "");
  EXPECT_EQ(nearest_word("--count" + std::string(100, 't'), options), "");
  EXPECT_EQ(nearest_word("--count", {}), "");
}

TEST(Suggestion, IsASentence) {
  EXPECT_EQ(suggestion("--coutn", options), "; did you mean --count?");
  EXPECT_EQ(suggestion("--cube", options), "");
}

}  // namespace
}  // namespace abut::io
