#pragma once

#include "io/snapshot.hpp"

#include <abut/pair.hpp>
#include <abut/progress.hpp>

#include <span>
#include <string>
#include <string_view>

namespace abut::io {

enum class ContactFormat { csv, json, vtp };

/// By name ("csv", "json", "vtp") or, if the name is empty, by the suffix of the path; CSV for "-".
/// Throws Error{wrong_usage} naming the formats there are.
[[nodiscard]] ContactFormat contact_format(std::string_view name, std::string_view path);

/// Whether columns with the file's own ids are added.
enum class IdColumns { without, with };

struct ContactOutput {
  std::string path;  ///< "-" is standard output
  ContactFormat format = ContactFormat::csv;
  IdColumns ids = IdColumns::without;
  ProgressHook progress;  ///< phase "write"; pairs; asked again before each system call
};

/// Writes the pairs in the order given, with their gaps.
///  csv   header i,j,gap (with ids: i,j,id_i,id_j,gap), gap as %.17g
///  json  one object: elements, dimensions, contact_pairs, columns: the names as in CSV, pairs:
///        [[i, j, gap], ...], numbers as the shortest texts that read back as the same doubles
///  vtp   VTK PolyData: elements as points with radius and coordination number, contacts as lines
///        with gap, ids where the snapshot has them; double precision, appended raw
/// Throws Error{output_failed}; Error{invalid_input} if ids are asked for and not there,
/// Error{wrong_usage} for an element that is not there; Error{cancelled}. A failed write leaves no
/// file and the old one untouched.
void write_contacts(const ContactOutput& output, const Snapshot& snapshot,
                    std::span<const ContactPair> pairs);

}  // namespace abut::io
