#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace abut::io {

/// Output that appears whole or not at all: written to a fresh temporary name beside the target,
/// synced and renamed by `commit`; removed if destroyed before. "-" is standard output, which is
/// only flushed. Every failure, that of closing included, throws Error{output_failed}; a closed
/// pipe on standard output throws ClosedPipe.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  void flush();
  [[noreturn]] void fail(const char* action) const;

  std::string path_;
  std::string temporary_;
  int descriptor_ = -1;
  std::string buffer_;
};

/// Nobody reads standard output any more: the tool ends quietly with exit code 0.
struct ClosedPipe {};

}  // namespace abut::io
