#pragma once

#include "io/snapshot.hpp"

#include <abut/domain.hpp>

#include <optional>
#include <string>
#include <vector>

namespace abut::cli {

/// The options of the command line about the domain; the rest is the file's.
struct DomainOptions {
  std::optional<Axes> periodic;
  std::vector<double> box;      ///< lengths
  std::vector<double> lattice;  ///< vector after vector
  std::string as_given;         ///< " --periodic xy --box 1,2", for commands that are proposed
};

/// "none", or letters x, y and z, each at most once. Throws Error{wrong_usage}.
[[nodiscard]] Axes axes_named(const std::string& text);

/// Numbers with commas between them. Throws Error{wrong_usage}.
[[nodiscard]] std::vector<double> number_list(const std::string& option, const std::string& text);

/// The domain of the elements. Throws Error{wrong_usage} where the options make none, or the file
/// names no box for its periodic axes; Error{invalid_input} where the box of the file makes none.
[[nodiscard]] Domain domain_of(const DomainOptions& options, const io::Snapshot& snapshot);

/// The domain of two sets of elements: that of the options, else of the file that names a box.
/// Throws Error{wrong_usage} where the boxes of both make different domains.
[[nodiscard]] Domain domain_of(const DomainOptions& options, const io::Snapshot& first,
                               const io::Snapshot& second);

/// Throws Error{wrong_usage} unless the domain is open; `what` completes "... takes open space".
void require_open(const DomainOptions& options, const io::Snapshot& snapshot,
                  const std::string& what);

/// "x and y"; empty where no axis is periodic.
[[nodiscard]] std::string axes_text(Axes axes);

/// The axes that the file calls periodic.
[[nodiscard]] Axes periodic_axes(const io::Snapshot& snapshot);

}  // namespace abut::cli
