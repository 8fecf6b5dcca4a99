#pragma once

#include "io/snapshot.hpp"
#include "io/write/output_file.hpp"

#include <abut/domain.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/progress.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace abut::io {

enum class ContactFormat { csv, json, vtp };

/// Returns the format by its name ("csv", "json", "vtp") or, if the name is empty, by the suffix of
/// the path; CSV for "-". Throws Error{wrong_usage} naming the formats there are.
[[nodiscard]] ContactFormat contact_format(std::string_view name, std::string_view path);

/// Columns with the file's own ids are added, or not.
enum class IdColumns { without, with };

struct ContactOutput {
  std::string path;  ///< "-" is standard output
  ContactFormat format = ContactFormat::csv;
  IdColumns ids = IdColumns::without;
  ProgressHook progress;  ///< phase "write"; pairs; asked again before each system call
};

/// The elements that pairs are of: those of one set, or of two, i of the first and j of the second.
struct ContactElements {
  ContactElements(const Snapshot& only) : first(only) {}
  ContactElements(const Snapshot& first_set, const Snapshot& second_set)
      : first(first_set), second(&second_set) {}

  const Snapshot& first;
  const Snapshot* second = nullptr;

  [[nodiscard]] bool are_of_two_sets() const noexcept { return second != nullptr; }
  /// The elements that j is one of.
  [[nodiscard]] const Snapshot& partners() const noexcept {
    return second != nullptr ? *second : first;
  }
  /// Number of elements of all sets.
  [[nodiscard]] std::size_t size() const noexcept {
    return first.size() + (second != nullptr ? second->size() : 0);
  }
};

/// The quantities that are known of the pairs, one entry each. Gaps are always written: those that
/// are not here are measured. Of the others those are written that are here.
struct ContactQuantities {
  std::span<const double> gaps = {};
  std::span<const Vector> normals = {};
  std::span<const Vector> points = {};
  std::span<const double> distances = {};
  std::span<const Vector> vectors = {};
};

/// The images of a periodic domain that the pairs are of; of an open domain nothing need be said.
struct ContactImages {
  std::span<const ImageShift> shifts;  ///< one a pair
  Domain domain = Domain::open();
};

/// Writes the pairs in the order given, with their gaps.
///  csv   header i,j,gap (with ids: i,j,id_i,id_j,gap), numbers as %.17g; in a periodic domain
///        nx,ny,nz stand before the gap; behind it the other quantities, as normal_x,normal_y,
///        normal_z,point_x,...,distance,vector_x,...
///  json  one object: elements, of two sets also sets: how many each has, dimensions,
///        contact_pairs, columns: the names as in CSV, pairs: [[i, j, gap, ...], ...], numbers as
///        the shortest texts that read back as the same doubles
///  vtp   VTK PolyData: elements as points with radius and coordination number, contacts as lines
///        with gap and the other quantities, ids where all have them; double precision, appended
///        raw. Elements of a second set stand behind those of the first, and `set` tells 0 from 1.
///        In a periodic domain lines carry their shift, and the line of a pair with a shift ends in
///        a point of its own, the image of j; `image` tells such points, which repeat j's data
/// Throws Error{output_failed}; Error{invalid_input} if ids are asked for and not there,
/// Error{wrong_usage} for an element, shift or quantity that is not there; Error{cancelled}. A
/// failed write leaves no file and the old one untouched.
Durability write_contacts(const ContactOutput& output, const ContactElements& elements,
                          std::span<const ContactPair> pairs, const ContactImages& images = {},
                          const ContactQuantities& quantities = {});

}  // namespace abut::io
