#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace abut::benchmarks {

/// The numbers that an option takes.
struct Within {
  double least = std::numeric_limits<double>::lowest();
  double most = std::numeric_limits<double>::max();
};
inline constexpr Within any_number{};
inline constexpr Within positive{1.0, 1e9};

/// The command line of a program, read by CLI11, which is compiled once for all of them.
class CommandLine {
 public:
  explicit CommandLine(const std::string& description);
  ~CommandLine();

  /// Adds an option. Values of a list are separated by commas. A string takes any text.
  template <class Value>
  void add(const std::string& name, Value& value, const std::string& help,
           const Within& within = any_number);
  /// Adds a list of words, each one of `known`.
  void add_words(const std::string& name, std::vector<std::string>& words, const std::string& help,
                 const std::vector<std::string>& known);
  /// Adds an option without a value.
  void add_flag(const std::string& name, bool& is_given, const std::string& help);
  /// Refuses an option without another one.
  void require_with(const std::string& name, const std::string& other);

  /// Reads the arguments. Returns the exit code if the program is to end: of wrong usage, or 0 when
  /// its help was shown.
  [[nodiscard]] std::optional<int> read(int argc, const char* const* argv);
  [[nodiscard]] bool has(const std::string& name) const;

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace abut::benchmarks
