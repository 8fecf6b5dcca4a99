#include "io/read/line_reader.hpp"

#include "io/quoted_text.hpp"
#include "io/read/foreign_format.hpp"

#include <abut/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace abut::io {
namespace {

constexpr std::size_t block_bytes = std::size_t{256} << 10;
constexpr std::size_t longest_line = std::size_t{1} << 20;
constexpr std::uint64_t bytes_between_reports = std::uint64_t{4} << 20;

std::string reason(int error) {
  return std::generic_category().message(error);
}

}  // namespace

LineReader::LineReader(const std::string& path, const ProgressHook& progress)
    : name_(path == "-" ? "standard input" : path), progress_(progress), block_(block_bytes) {
  open(path);
  try {
    begin_text(path);
  } catch (...) {
    if (owns_descriptor_) ::close(descriptor_);
    throw;
  }
}

LineReader::~LineReader() {
  if (owns_descriptor_) ::close(descriptor_);
}

void LineReader::open(const std::string& path) {
  if (path == "-") {
    descriptor_ = STDIN_FILENO;
  } else {
    if (path.find('\0') != std::string::npos) {
      fail("a file name cannot hold a NUL byte");
    }
    for (;;) {
      descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
      if (descriptor_ >= 0 || errno != EINTR) break;
      report(true);
    }
    if (descriptor_ < 0) {
      fail(fmt::format("cannot be opened ({}); check the name and its permissions", reason(errno)));
    }
    owns_descriptor_ = true;
  }
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return;
  // Files of /proc call themselves regular and have size 0.
  const off_t here = ::lseek(descriptor_, 0, SEEK_CUR);
  if (status.st_size <= 0 || here < 0 || here > status.st_size) return;
  first_byte_ = static_cast<std::uint64_t>(here);
  bytes_ = static_cast<std::uint64_t>(status.st_size - here);
}

void LineReader::begin_text(const std::string& path) {
  report(true);
  while (end_ < telling_bytes && fill()) {
  }
  const std::string_view text(block_.data(), end_);
  if (text.starts_with("\xEF\xBB\xBF")) begin_ = 3;
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    fail("is UTF-16 text; save it as UTF-8");
  }
  if (const std::optional<std::string> what = foreign_format({text.substr(begin_), bytes_}, path)) {
    fail(*what);
  }
}

std::optional<std::string_view> LineReader::next() {
  std::size_t searched = begin_;
  for (;;) {
    const char* const found =
        static_cast<const char*>(std::memchr(block_.data() + searched, '\n', end_ - searched));
    if (found != nullptr) {
      const auto stop = static_cast<std::size_t>(found - block_.data());
      const std::string_view line(block_.data() + begin_, stop - begin_);
      begin_ = stop + 1;
      ++line_;
      return checked(line);
    }
    const std::size_t length = end_ - begin_;
    if (length > longest_line) {
      ++line_;
      fail_at_line("is longer than 1 MiB; this is not a table of elements");
    }
    if (!fill()) break;
    searched = begin_ + length;
  }
  if (begin_ == end_) return std::nullopt;
  const std::string_view line(block_.data() + begin_, end_ - begin_);
  begin_ = end_;
  ++line_;
  return checked(line);
}

std::string_view LineReader::checked(std::string_view line) const {
  // Some conversions between systems leave several carriage returns at the end of a line.
  while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line.size() > longest_line) {
    fail_at_line("is longer than 1 MiB; this is not a table of elements");
  }
  if (!line.empty() && std::memchr(line.data(), 0, line.size()) != nullptr) {
    fail_at_line("holds a NUL byte; this is not a text file, or it is damaged");
  }
  if (!line.empty() && std::memchr(line.data(), '\r', line.size()) != nullptr) {
    fail_at_line("holds a carriage return; lines must end with LF or CR LF: convert the file");
  }
  return line;
}

void LineReader::skip(std::uint64_t lines) {
  bool inside = false;  // of a line whose end is not in the block
  while (lines > 0) {
    const char* const from = block_.data() + begin_;
    const char* const found = static_cast<const char*>(std::memchr(from, '\n', end_ - begin_));
    if (found != nullptr) {
      begin_ += static_cast<std::size_t>(found - from) + 1;
      ++line_;
      --lines;
      inside = false;
      continue;
    }
    inside = inside || begin_ != end_;
    begin_ = end_;
    if (fill()) continue;
    if (inside) ++line_;
    return;
  }
}

std::optional<std::string_view> LineReader::peek() {
  const TextPosition start = position();
  const std::optional<std::string_view> line = next();
  // `next` has dropped nothing from the beginning of the line on.
  begin_ = static_cast<std::size_t>(start.offset - block_offset_);
  line_ = start.line;
  return line;
}

bool LineReader::skip_blank_lines() {
  while (const std::optional<std::string_view> line = peek()) {
    if (line->find_first_not_of(" \t\r\f\v") != std::string_view::npos) return true;
    skip(1);
  }
  return false;
}

void LineReader::seek(TextPosition position) {
  line_ = position.line;
  if (position.offset >= block_offset_ && position.offset <= block_offset_ + end_) {
    begin_ = static_cast<std::size_t>(position.offset - block_offset_);
    return;
  }
  begin_ = end_ = 0;
  block_offset_ = position.offset;
  if (::lseek(descriptor_, static_cast<off_t>(first_byte_ + position.offset), SEEK_SET) < 0) {
    fail(fmt::format("cannot be read again from byte {} ({})", position.offset, reason(errno)));
  }
}

std::optional<std::uint64_t> LineReader::bytes_left() const noexcept {
  if (!bytes_) return std::nullopt;
  const std::uint64_t here = block_offset_ + begin_;
  // A file that has grown since holds at least what was read of it.
  return std::max(*bytes_, block_offset_ + end_) - here;
}

bool LineReader::fill() {
  make_room();
  report(false);
  for (;;) {
    const ssize_t count = ::read(descriptor_, block_.data() + end_, block_.size() - end_);
    if (count > 0) {
      end_ += static_cast<std::size_t>(count);
      return true;
    }
    if (count == 0) return false;
    const int error = errno;
    if (error == EINTR) {
      report(true);
      continue;
    }
    if (error == EISDIR) fail("is a folder; name a file");
    fail(fmt::format("cannot be read ({})", reason(error)));
  }
}

/// Drops what was returned and need not be kept; then grows if the block is full.
void LineReader::make_room() {
  std::size_t first = begin_;
  if (!bytes_ && kept_offset_) {
    const std::uint64_t kept = std::max(*kept_offset_, block_offset_);
    first = std::min(first, static_cast<std::size_t>(kept - block_offset_));
  }
  // Moving at most as many bytes as are dropped keeps the cost linear.
  if (first > 0 && end_ - first <= first) {
    std::memmove(block_.data(), block_.data() + first, end_ - first);
    begin_ -= first;
    end_ -= first;
    block_offset_ += first;
  }
  if (block_.size() - end_ < block_bytes / 2) block_.resize(2 * block_.size());
}

void LineReader::report(bool always) {
  const std::uint64_t here = block_offset_ + end_;
  const std::uint64_t moved = here > reported_ ? here - reported_ : reported_ - here;
  if (!progress_ || (!always && moved < bytes_between_reports)) return;
  reported_ = here;
  if (progress_({"read", here, bytes_.value_or(0)}) == ProgressAction::proceed) return;
  throw Error(ErrorCode::cancelled,
              fmt::format("cancelled while reading {} after {} bytes", shown_name(), here));
}

std::string LineReader::shown_name() const {
  return name_.empty() ? "''" : visible(name_);
}

void LineReader::fail(std::string_view what) const {
  throw Error(ErrorCode::invalid_input, fmt::format("{}: {}", shown_name(), what));
}

void LineReader::fail_at_line(std::string_view what) const {
  throw Error(ErrorCode::invalid_input, fmt::format("{}, line {}: {}", shown_name(), line_, what));
}

void LineReader::fail_at_next_line(std::string_view what) const {
  throw Error(ErrorCode::invalid_input,
              fmt::format("{}, line {}: {}", shown_name(), line_ + 1, what));
}

void LineReader::fail_in_column(std::string_view column, std::string_view what) const {
  throw Error(ErrorCode::invalid_input,
              fmt::format("{}, line {}, column {}: {}", shown_name(), line_, column, what));
}

}  // namespace abut::io
