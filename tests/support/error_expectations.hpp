#pragma once

#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace abut::testing {

/// `call` throws abut::Error with that code, and its sentence holds all of the words.
inline void expect_error(ErrorCode code, std::initializer_list<std::string_view> words,
                         const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(error.code(), code) << sentence;
    for (const std::string_view word : words) {
      EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' in: " << sentence;
    }
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
}

}  // namespace abut::testing
