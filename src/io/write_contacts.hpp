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
  ProgressHook progress;  ///< phase "write"; pairs
};

/// Writes the pairs in the order given, with their gaps.
///  csv   header i,j,gap (with ids: i,j,id_i,id_j,gap), gap as %.17g
///  json  one object: elements, dimensions, contact_pairs, pairs: [[i, j, gap], ...]
///  vtp   VTK PolyData: elements as points with radius and coordination number, contacts as lines
///        with gap; double precision, appended raw
/// Throws Error{output_failed}; a failed write leaves no file and the old one untouched.
void write_contacts(const ContactOutput& output, const Snapshot& snapshot,
                    std::span<const ContactPair> pairs);

}  // namespace abut::io
