#pragma once

#include "console.hpp"
#include "io/snapshot.hpp"
#include "io/write/write_contacts.hpp"
#include "load_snapshot.hpp"

#include <abut/domain.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace abut::cli {

/// The elements of a file, or of two files against each other, and where they live.
struct ElementSets {
  io::Snapshot first;
  std::optional<io::Snapshot> second;
  Domain domain = Domain::open();

  [[nodiscard]] bool are_two() const noexcept { return second.has_value(); }
  /// The elements that the second number of a pair names.
  [[nodiscard]] const io::Snapshot& partners() const noexcept { return second ? *second : first; }
  [[nodiscard]] io::ContactElements elements() const {
    return second ? io::ContactElements(first, *second) : io::ContactElements(first);
  }
};

/// Reads the file of `input`, and with a path behind `--against` that one in the same way; then a
/// frame that is asked for need not be that of a file of one. Throws Error{wrong_usage} where the
/// two do not fit each other.
[[nodiscard]] ElementSets load_sets(const InputOptions& input, const std::string& against,
                                    Console& console);

/// Throws Error{wrong_usage} if standard input stands for several of the paths.
void require_one_standard_input(std::initializer_list<std::string_view> paths);

}  // namespace abut::cli
