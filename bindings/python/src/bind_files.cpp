#include "array_out.hpp"
#include "bind.hpp"
#include "elements.hpp"
#include "io/read/read_snapshot.hpp"
#include "io/write/write_contacts.hpp"
#include "io/write/write_elements.hpp"
#include "pair_arrays.hpp"
#include "progress_calls.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut::python {

namespace {

/// A column of elements as the writers want it.
std::vector<double> column_of(const ElementView& view, const ElementView::Numbers& numbers) {
  std::vector<double> column(view.size());
  for (std::size_t k = 0; k < column.size(); ++k) {
    const std::byte* place = numbers.first + static_cast<std::ptrdiff_t>(k) * numbers.stride_bytes;
    column[k] = view.precision() == Precision::float32
                    ? static_cast<double>(*reinterpret_cast<const float*>(place))
                    : *reinterpret_cast<const double*>(place);
  }
  return column;
}

void fill_spheres(io::Snapshot& snapshot, const ElementView& view) {
  snapshot.x = column_of(view, view.center(0));
  snapshot.y = column_of(view, view.center(1));
  if (view.dimensions() == 3) snapshot.z = column_of(view, view.center(2));
  snapshot.radius = view.has_common_radius()
                        ? std::vector<double>(view.size(), view.common_radius())
                        : column_of(view, view.radii());
}

/// Centers and half the widest side, for pictures; the corners decide gaps.
void fill_boxes(io::Snapshot& snapshot, const ElementView& view) {
  snapshot.shape = Shape::box;
  snapshot.radius.assign(view.size(), 0.0);
  const std::array centers{&snapshot.x, &snapshot.y, &snapshot.z};
  for (int axis = 0; axis < view.dimensions(); ++axis) {
    const auto place = static_cast<std::size_t>(axis);
    snapshot.lower[place] = column_of(view, view.lower(axis));
    snapshot.upper[place] = column_of(view, view.upper(axis));
    centers[place]->resize(view.size());
    for (std::size_t k = 0; k < view.size(); ++k) {
      const double half_lower = 0.5 * snapshot.lower[place][k];
      const double half_upper = 0.5 * snapshot.upper[place][k];
      (*centers[place])[k] = half_lower + half_upper;
      snapshot.radius[k] = std::max(snapshot.radius[k], half_upper - half_lower);
    }
  }
}

io::Snapshot snapshot_of(const Elements& elements) {
  const ElementView& view = elements.view();
  io::Snapshot snapshot;
  snapshot.dimensions = view.dimensions();
  if (view.shape() == Shape::sphere) {
    fill_spheres(snapshot, view);
  } else {
    fill_boxes(snapshot, view);
  }
  return snapshot;
}

nb::list columns_of(io::Snapshot& snapshot) {
  nb::list columns;
  if (!snapshot.holds_boxes()) {
    columns.append(given_away(std::move(snapshot.x)));
    columns.append(given_away(std::move(snapshot.y)));
    if (snapshot.dimensions == 3) columns.append(given_away(std::move(snapshot.z)));
    return columns;
  }
  for (auto* corners : {&snapshot.lower, &snapshot.upper}) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(snapshot.dimensions); ++axis) {
      columns.append(given_away(std::move((*corners)[axis])));
    }
  }
  return columns;
}

nb::dict read(const std::string& path, const std::string& format, std::optional<double> radius,
              std::optional<std::int64_t> frame, const std::string& groups, nb::handle progress) {
  io::ReadOptions options;
  options.format = format;
  options.radius = radius;
  options.frame = frame;
  options.groups = groups;
  options.progress = progress_hook(progress);
  io::Snapshot snapshot = [&] {
    const nb::gil_scoped_release unlocked;
    return io::read_snapshot(path, options);
  }();
  nb::dict fields;
  fields["is_of_boxes"] = snapshot.holds_boxes();
  fields["dimensions"] = snapshot.dimensions;
  fields["columns"] = columns_of(snapshot);
  fields["radius"] = given_away(std::move(snapshot.radius));
  fields["ids"] = given_away(std::move(snapshot.ids));
  fields["groups"] = given_away(std::move(snapshot.groups));
  fields["periodic"] = nb::cast(snapshot.periodic);
  fields["box"] = nb::cast(snapshot.box);
  fields["format"] = nb::cast(snapshot.format);
  fields["frame"] = snapshot.frame;
  fields["frame_count"] = snapshot.frame_count;
  return fields;
}

void write_pairs(const std::string& path, const std::string& format, const Elements& elements,
                 const Elements* others, const Domain& domain, nb::handle pairs,
                 nb::handle shifts) {
  const PairArrays arrays(pairs, shifts);
  io::ContactOutput output;
  output.path = path;
  output.format = io::contact_format(format, path);
  output.progress = progress_hook(nb::none());
  const nb::gil_scoped_release unlocked;
  const io::Snapshot first = snapshot_of(elements);
  const io::ContactImages images{arrays.shifts(), domain};
  if (others == nullptr) {
    io::write_contacts(output, first, arrays.pairs(), images);
  } else {
    const io::Snapshot second = snapshot_of(*others);
    io::write_contacts(output, io::ContactElements(first, second), arrays.pairs(), images);
  }
}

void write_all(const std::string& path, const std::string& format, const Elements& elements) {
  const nb::gil_scoped_release unlocked;
  io::write_elements(path, format, snapshot_of(elements));
}

}  // namespace

void bind_files(nb::module_& module) {
  module.def("read", &read, nb::arg("path"), nb::arg("format"), nb::arg("radius").none(),
             nb::arg("frame").none(), nb::arg("groups"), nb::arg("progress").none());
  module.def("write_contacts", &write_pairs, nb::arg("path"), nb::arg("format"),
             nb::arg("elements"), nb::arg("others").none(), nb::arg("domain"), nb::arg("pairs"),
             nb::arg("shifts").none());
  module.def("write_elements", &write_all, nb::arg("path"), nb::arg("format"), nb::arg("elements"));
}

}  // namespace abut::python
