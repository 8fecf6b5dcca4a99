#include "options/domain_options.hpp"

#include "options/argument.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace abut::cli {
namespace {

constexpr std::string_view letters = "xyz";

bool contains(Axes axes, std::size_t axis) {
  return (static_cast<unsigned>(axes) >> axis & 1U) != 0;
}

Axes with(Axes axes, std::size_t axis) {
  return static_cast<Axes>(static_cast<unsigned>(axes) | 1U << axis);
}

[[noreturn]] void reject_count(const std::string& option, std::size_t count,
                               std::string_view wanted, const io::Snapshot& snapshot) {
  throw Error(ErrorCode::wrong_usage,
              fmt::format("{}: {} numbers for {}; give {}", option, count,
                          snapshot.dimensions == 2 ? "discs" : "spheres", wanted));
}

Domain domain_of_box(const DomainOptions& options, const io::Snapshot& snapshot) {
  std::vector<double> lengths = options.box;
  if (lengths.size() != static_cast<std::size_t>(snapshot.dimensions)) {
    reject_count("--box", lengths.size(), snapshot.dimensions == 2 ? "lx,ly" : "lx,ly,lz",
                 snapshot);
  }
  if (options.periodic.has_value()) {
    for (std::size_t axis = 0; axis < lengths.size(); ++axis) {
      if (!contains(*options.periodic, axis)) {
        lengths[axis] = unbounded;
      } else if (std::isinf(lengths[axis])) {
        throw Error(ErrorCode::wrong_usage,
                    fmt::format("--periodic names {0}, and --box gives that axis no end; give its "
                                "length, or leave {0} out",
                                letters[axis]));
      }
    }
  }
  return lengths.size() == 2 ? Domain::periodic({lengths[0], lengths[1]})
                             : Domain::periodic({lengths[0], lengths[1], lengths[2]});
}

Domain domain_of_vectors(const io::Snapshot& snapshot,
                         const std::array<std::array<double, 3>, 3>& rows, Axes axes) {
  if (snapshot.dimensions == 3) return Domain::lattice(rows[0], rows[1], rows[2], axes);
  return Domain::lattice({rows[0][0], rows[0][1]}, {rows[1][0], rows[1][1]}, axes);
}

Domain domain_of_lattice(const DomainOptions& options, const io::Snapshot& snapshot) {
  const std::size_t dimensions = snapshot.dimensions == 2 ? 2 : 3;
  const std::vector<double>& numbers = options.lattice;
  if (numbers.size() != dimensions * dimensions) {
    reject_count("--lattice", numbers.size(), dimensions == 2 ? "4" : "9", snapshot);
  }
  std::array<std::array<double, 3>, 3> rows{};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    rows[k / dimensions][k % dimensions] = numbers[k];
  }
  return domain_of_vectors(snapshot, rows,
                           options.periodic.value_or(dimensions == 2 ? Axes::xy : Axes::xyz));
}

/// The elements of a plane have no third axis that could be periodic.
void require_axes(const DomainOptions& options, const io::Snapshot& snapshot) {
  if (snapshot.dimensions == 3 || !options.periodic || !contains(*options.periodic, 2)) return;
  throw Error(
      ErrorCode::wrong_usage,
      fmt::format("--periodic names z, and {} has two dimensions; leave z out", snapshot.name()));
}

Domain domain_of_file(const DomainOptions& options, const io::Snapshot& snapshot) {
  const Axes axes = options.periodic.value_or(periodic_axes(snapshot));
  if (axes == Axes::none) return Domain::open();
  if (!snapshot.box.has_value()) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("{}: periodic in {}, but the file names no box; give --box or "
                            "--lattice, or --periodic none to take it as open",
                            snapshot.name(), axes_text(axes)));
  }
  return domain_of_vectors(snapshot, *snapshot.box, axes);
}

/// "open", or "periodic along (9, 0, 0)", with all digits.
std::string domain_words(const Domain& domain) {
  std::string vectors;
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain.is_periodic(axis)) continue;
    const auto& [x, y, z] = domain.vector(axis);
    vectors += fmt::format("{}({}, {}, {})", vectors.empty() ? "" : " and ", x, y, z);
  }
  return vectors.empty() ? "open" : "periodic along " + vectors;
}

}  // namespace

Axes axes_named(const std::string& text) {
  static constexpr std::string_view wanted = "none, or axes such as x, xy or xyz";
  if (text == "none") return Axes::none;
  Axes axes = Axes::none;
  for (const char letter : text) {
    const std::size_t axis = letters.find(letter);
    if (axis == std::string_view::npos || contains(axes, axis)) {
      reject("--periodic", text, wanted);
    }
    axes = with(axes, axis);
  }
  if (text.empty()) reject("--periodic", text, wanted);
  return axes;
}

std::vector<double> number_list(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string field = text.substr(start, end - start);
    numbers.push_back(number<double>(option, field, "numbers with commas between them"));
    start = end + 1;
  }
  return numbers;
}

Domain domain_of(const DomainOptions& options, const io::Snapshot& snapshot) {
  const bool of_file = options.box.empty() && options.lattice.empty();
  require_axes(options, snapshot);
  try {
    if (!options.lattice.empty()) return domain_of_lattice(options, snapshot);
    return of_file ? domain_of_file(options, snapshot) : domain_of_box(options, snapshot);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::wrong_usage) throw;
    if (of_file) throw Error(error.code(), fmt::format("{}: {}", snapshot.name(), error.what()));
    throw Error(
        ErrorCode::wrong_usage,
        fmt::format("{}: {}", options.lattice.empty() ? "--box" : "--lattice", error.what()));
  }
}

Domain domain_of(const DomainOptions& options, const io::Snapshot& first,
                 const io::Snapshot& second) {
  const bool of_files = options.box.empty() && options.lattice.empty();
  if (!of_files || !second.box.has_value()) return domain_of(options, first);
  if (!first.box.has_value()) return domain_of(options, second);
  const Domain domain = domain_of(options, first);
  const Domain other = domain_of(options, second);
  if (domain == other) return domain;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("{} is {} and {} is {}; say what holds for both with --box, --lattice "
                          "or --periodic",
                          first.name(), domain_words(domain), second.name(), domain_words(other)));
}

void require_open(const DomainOptions& options, const io::Snapshot& snapshot,
                  const std::string& what) {
  const Domain domain = domain_of(options, snapshot);
  if (!domain.is_periodic()) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("{}: the domain is periodic in {}, and {} takes open space; give "
                          "--periodic none",
                          snapshot.name(), axes_text(domain.periodic_axes()), what));
}

std::string axes_text(Axes axes) {
  std::string text;
  for (std::size_t axis = 0; axis < letters.size(); ++axis) {
    if (!contains(axes, axis)) continue;
    if (!text.empty()) text += axes == Axes::xyz && axis == 1 ? ", " : " and ";
    text += letters[axis];
  }
  return text;
}

Axes periodic_axes(const io::Snapshot& snapshot) {
  Axes axes = Axes::none;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (snapshot.periodic[axis]) axes = with(axes, axis);
  }
  return axes;
}

}  // namespace abut::cli
