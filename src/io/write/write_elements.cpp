#include "io/write/write_elements.hpp"

#include "io/quoted_text.hpp"
#include "io/suffix.hpp"
#include "io/write/output_file.hpp"
#include "io/write/text_output.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace abut::io {
namespace {

enum class ElementFormat { csv, lammps_dump, xyz };

ElementFormat element_format(std::string_view name, std::string_view path) {
  const std::string suffix = path == "-" ? "" : suffix_of(path);
  const std::string wanted = name.empty() ? suffix : fmt::format(".{}", name);
  if (wanted == ".lammps_dump" || has_word(".dump .lammpstrj .lammps", wanted)) {
    return ElementFormat::lammps_dump;
  }
  if (has_word(".xyz .extxyz", wanted)) return ElementFormat::xyz;
  if (wanted.empty() || has_word(".csv .txt", wanted)) return ElementFormat::csv;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("elements cannot be written as {}; the formats are csv, lammps_dump and "
                          "xyz",
                          quoted(std::string_view(wanted).substr(1))));
}

/// The columns of the elements in the order in which every format here writes them.
std::vector<const std::vector<double>*> columns_of(const Snapshot& snapshot) {
  if (snapshot.dimensions == 2) return {&snapshot.x, &snapshot.y, &snapshot.radius};
  return {&snapshot.x, &snapshot.y, &snapshot.z, &snapshot.radius};
}

void require_finite(const Snapshot& snapshot) {
  for (const std::vector<double>* column : columns_of(snapshot)) {
    const auto bad = std::find_if(column->begin(), column->end(),
                                  [](double value) { return !std::isfinite(value); });
    if (bad == column->end()) continue;
    throw Error(ErrorCode::invalid_input,
                fmt::format("element {} has a number that is not finite, which no reader accepts",
                            bad - column->begin()));
  }
}

/// The file and who is told how much of it is written.
class ElementWriter {
 public:
  ElementWriter(const std::string& path, std::size_t elements, const ProgressHook& progress)
      : progress_(progress), now_{"write", 0, elements}, file_(path, [this] {
          return progress_ && progress_(now_) == ProgressAction::cancel;
        }) {}

  void write(std::string_view text) { file_.write(text); }
  void write_row(std::string_view row) {
    file_.write(row);
    ++now_.done;
  }
  Durability commit() { return file_.commit(); }

 private:
  const ProgressHook& progress_;
  Progress now_;
  OutputFile file_;
};

void write_rows(ElementWriter& file, const Snapshot& snapshot, std::string_view first_field,
                char separator) {
  const std::vector<const std::vector<double>*> columns = columns_of(snapshot);
  std::string row;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    row = first_field;
    for (const std::vector<double>* column : columns) {
      if (!row.empty()) row += separator;
      append_shortest((*column)[k], row);
    }
    if (!snapshot.ids.empty()) {
      row += separator;
      append_integer(snapshot.ids[k], row);
    }
    row += '\n';
    file.write_row(row);
  }
}

void write_csv(ElementWriter& file, const Snapshot& snapshot) {
  file.write(snapshot.dimensions == 2 ? "x,y,radius" : "x,y,z,radius");
  file.write(snapshot.ids.empty() ? "\n" : ",id\n");
  write_rows(file, snapshot, "", ',');
}

/// The smallest upright box around the centres; [0, 0] where there are none.
std::string box_line(const std::vector<double>& column) {
  double low = 0.0;
  double high = 0.0;
  if (!column.empty()) {
    const auto [least, most] = std::minmax_element(column.begin(), column.end());
    low = *least;
    high = *most;
  }
  std::string line;
  append_shortest(low, line);
  line += ' ';
  append_shortest(high, line);
  return line + '\n';
}

void write_dump(ElementWriter& file, const Snapshot& snapshot) {
  file.write(fmt::format("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{}\n", snapshot.size()));
  file.write("ITEM: BOX BOUNDS ff ff ff\n");
  for (const std::vector<double>* column : {&snapshot.x, &snapshot.y, &snapshot.z}) {
    file.write(box_line(*column));
  }
  file.write(snapshot.dimensions == 2 ? "ITEM: ATOMS x y radius" : "ITEM: ATOMS x y z radius");
  file.write(snapshot.ids.empty() ? "\n" : " id\n");
  write_rows(file, snapshot, "", ' ');
}

void write_xyz(ElementWriter& file, const Snapshot& snapshot) {
  file.write(fmt::format("{}\nProperties=species:S:1:pos:R:{}:radius:R:1{} pbc=\"F F F\"\n",
                         snapshot.size(), snapshot.dimensions,
                         snapshot.ids.empty() ? "" : ":id:I:1"));
  write_rows(file, snapshot, "X", ' ');
}

}  // namespace

void require_element_format(const std::string& path, std::string_view format) {
  static_cast<void>(element_format(format, path));
}

Durability write_elements(const std::string& path, std::string_view format,
                          const Snapshot& snapshot, const ProgressHook& progress) {
  const ElementFormat chosen = element_format(format, path);
  require_finite(snapshot);
  ElementWriter file(path, snapshot.size(), progress);
  switch (chosen) {
    case ElementFormat::csv:
      write_csv(file, snapshot);
      break;
    case ElementFormat::lammps_dump:
      write_dump(file, snapshot);
      break;
    case ElementFormat::xyz:
      write_xyz(file, snapshot);
      break;
  }
  return file.commit();
}

}  // namespace abut::io
