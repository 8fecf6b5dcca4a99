#pragma once

#include <abut/progress.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {

/// A place between two lines of a text.
struct TextPosition {
  std::uint64_t offset = 0;  ///< bytes before it
  std::uint64_t line = 0;    ///< lines before it
};

/// The lines of a file or of standard input ("-"), read in large blocks. Memory follows the longest
/// line, or what `keep_from` asks to keep of a pipe. Line ends are LF or CR LF, and a CR anywhere
/// else is an error, since a file of another system's lines would look like one line; a byte order
/// mark of UTF-8 is skipped. Every failure throws Error{invalid_input} naming the file and the
/// line.
class LineReader {
 public:
  LineReader(const std::string& path, const ProgressHook& progress);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// The next line without its end, valid until the next call; nothing at the end of the file.
  [[nodiscard]] std::optional<std::string_view> next();

  /// The line that `next` will return.
  [[nodiscard]] std::optional<std::string_view> peek();

  /// Passes over lines without looking into them; fewer at the end of the file.
  void skip(std::uint64_t lines);

  /// Passes over blank lines; whether anything follows.
  [[nodiscard]] bool skip_blank_lines();

  [[nodiscard]] TextPosition position() const noexcept { return {block_offset_ + begin_, line_}; }

  /// `seek` will not go before this position.
  void keep_from(TextPosition position) noexcept { kept_offset_ = position.offset; }

  /// Back to a position not before the one of `keep_from`.
  void seek(TextPosition position);

  /// Bytes from here to the end where that is known: in a regular file.
  [[nodiscard]] std::optional<std::uint64_t> bytes_left() const noexcept;

  /// The file's name as given, "standard input" for "-".
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  /// "NAME: what"
  [[noreturn]] void fail(std::string_view what) const;
  /// "NAME, line N: what", N the line that `next` returned last.
  [[noreturn]] void fail_at_line(std::string_view what) const;
  /// Says what is wrong with the line that `next` will return.
  [[noreturn]] void fail_at_next_line(std::string_view what) const;
  /// "NAME, line N, column C: what"
  [[noreturn]] void fail_in_column(std::string_view column, std::string_view what) const;

 private:
  void open(const std::string& path);
  void begin_text(const std::string& path);
  [[nodiscard]] bool fill();
  void make_room();
  void report(bool always);
  [[nodiscard]] std::string shown_name() const;
  [[nodiscard]] std::string_view checked(std::string_view line) const;

  std::string name_;
  const ProgressHook& progress_;
  int descriptor_ = -1;
  bool owns_descriptor_ = false;
  std::uint64_t first_byte_ = 0;        ///< where the text begins in the file
  std::optional<std::uint64_t> bytes_;  ///< of the text; unknown for pipes and devices

  std::vector<char> block_;
  std::size_t begin_ = 0;  ///< block_[begin_, end_) is read and not yet returned
  std::size_t end_ = 0;
  std::uint64_t block_offset_ = 0;  ///< of block_[0] in the text
  std::uint64_t line_ = 0;          ///< lines returned or skipped
  std::uint64_t reported_ = 0;
  std::optional<std::uint64_t> kept_offset_;
};

}  // namespace abut::io
