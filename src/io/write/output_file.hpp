#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace abut::io {

/// Answers whether the writing is to be given up.
using GiveUp = std::function<bool()>;

/// Certainty that output which was written outlives a stop of the machine.
enum class Durability {
  synced,          ///< as sure as the place can make it
  name_not_synced  ///< the file is there, but syncing its folder failed: the old one may come back
};

/// Output that appears whole or not at all: written to a fresh temporary name beside the target,
/// synced and renamed by `commit`; removed if destroyed before. A link is followed and what it
/// points to is replaced; an existing file keeps its permissions. "-" is standard output; it,
/// devices and pipes are written straight, as far as the writing gets.
/// Every failure before the output is there, that of closing included, throws Error{output_failed};
/// a closed pipe on standard output throws ClosedPipe, if the program ignores SIGPIPE. A file that
/// would be too large is reported if the program ignores SIGXFSZ. `give_up` is asked before each
/// system call that may block and when a signal has interrupted one; yes throws Error{cancelled}.
class OutputFile {
 public:
  explicit OutputFile(std::string path, GiveUp give_up = {});
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  Durability commit();

 private:
  void open_standard_output(int descriptor);
  void open_straight();
  void open_temporary();
  void flush();
  void stop_if_given_up() const;
  void sync() const;
  void close();
  [[nodiscard]] Durability sync_folder() const noexcept;
  void discard() noexcept;
  void forget_temporary() noexcept;
  [[nodiscard]] std::string name() const;
  [[noreturn]] void fail(std::string_view action, int error) const;

  std::string path_;  ///< as given, for messages
  GiveUp give_up_;
  std::string target_;     ///< what the links of `path_` lead to
  std::string temporary_;  ///< empty if written straight
  int descriptor_ = -1;
  bool standard_output_ = false;
  std::string buffer_;
};

/// Removes the temporary of the output that is being written, if there is one: for the handler of a
/// signal that ends the process. Safe there.
void remove_temporary_in_handler() noexcept;

/// Nobody reads standard output any more: the tool ends quietly with exit code 0.
struct ClosedPipe {};

}  // namespace abut::io
