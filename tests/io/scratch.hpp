#pragma once

#include "io/read/read_snapshot.hpp"

#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <signal.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace abut::io::testing {

/// A folder of its own for one test, removed at the end.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "abut_io_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed for " + name);
    folder_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::string path(std::string_view name) const { return (folder_ / name).string(); }

  [[nodiscard]] std::string file(std::string_view name, std::string_view text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

 private:
  std::filesystem::path folder_;
};

inline std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Reads a text as a file with that name.
inline Snapshot read_text(std::string_view name, std::string_view text,
                          const ReadOptions& options = {}) {
  const Scratch scratch;
  return read_snapshot(scratch.file(name, text), options);
}

/// Reads a text from a pipe, whose size nobody knows.
inline Snapshot read_piped(std::string_view text, const ReadOptions& options = {}) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("pipe failed");
  std::jthread writer([text, end = ends[1]]() mutable {
    // A reader that refuses the text early closes the pipe.
    sigset_t closed_pipe;
    sigemptyset(&closed_pipe);
    sigaddset(&closed_pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &closed_pipe, nullptr);
    while (!text.empty()) {
      const ssize_t count = ::write(end, text.data(), text.size());
      if (count <= 0) break;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    ::close(end);
  });
  struct Closer {
    int descriptor;
    ~Closer() { ::close(descriptor); }
  };
  const Closer closer{ends[0]};  // closed before the writer is joined: it never waits for a reader
  return read_snapshot("/dev/fd/" + std::to_string(ends[0]), options);
}

inline ReadOptions at_frame(std::int64_t frame) {
  ReadOptions options;
  options.frame = frame;
  return options;
}

inline ReadOptions with_radius(double radius) {
  ReadOptions options;
  options.radius = radius;
  return options;
}

/// The sentence of the Error that an action throws; the code is checked.
template <class Action>
std::string sentence_of(ErrorCode code, const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error was thrown";
  return {};
}

using Numbers = std::vector<double>;

}  // namespace abut::io::testing
