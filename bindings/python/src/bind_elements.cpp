#include "bind.hpp"
#include "elements.hpp"

#include <abut/column.hpp>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string_view.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace abut::python {

namespace {

/// A number for each element in memory of Python.
struct ByteColumn {
  const std::byte* first;
  std::size_t size;
  std::ptrdiff_t stride_bytes;

  template <Real T>
  [[nodiscard]] Column<T> of() const noexcept {
    return {reinterpret_cast<const T*>(first), size, stride_bytes};
  }
};

/// Columns of one type of number, and what keeps them.
class Columns {
 public:
  /// Takes a table with a row for each element, or a tuple of columns.
  explicit Columns(nb::handle numbers) { add(numbers); }
  /// Takes a table.
  explicit Columns(NumberBuffer table) { add(std::move(table)); }

  void add(nb::handle numbers) {
    if (nb::isinstance<nb::tuple>(numbers)) {
      for (const nb::handle column : nb::borrow<nb::tuple>(numbers)) add(NumberBuffer(column));
    } else {
      add(NumberBuffer(numbers));
    }
  }

  void add(NumberBuffer array) {
    const NumberBuffer& buffer = buffers_.emplace_back(std::move(array));
    const char letter = buffer.letter();
    if (letter_ == '\0') letter_ = letter;
    if (letter != letter_ || (letter != 'f' && letter != 'd')) {
      throw nb::type_error("arrays of float32 or float64 are needed, all of one type");
    }
    if (buffer.axes() == 1) {
      columns_.push_back({buffer.first(), buffer.size(0), buffer.stride_bytes(0)});
      return;
    }
    if (buffer.axes() != 2) throw nb::value_error("arrays of one or two axes are needed");
    for (std::size_t k = 0; k < buffer.size(1); ++k) {
      const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(k) * buffer.stride_bytes(1);
      columns_.push_back({buffer.first() + offset, buffer.size(0), buffer.stride_bytes(0)});
    }
  }

  [[nodiscard]] std::size_t size() const noexcept { return columns_.size(); }
  [[nodiscard]] bool are_float() const noexcept { return letter_ == 'f'; }
  [[nodiscard]] std::vector<NumberBuffer> take_buffers() { return std::move(buffers_); }

  template <Real T, std::size_t Dim>
  [[nodiscard]] std::array<Column<T>, Dim> from(std::size_t first) const {
    std::array<Column<T>, Dim> result;
    for (std::size_t axis = 0; axis < Dim; ++axis) result[axis] = of<T>(first + axis);
    return result;
  }
  template <Real T>
  [[nodiscard]] Column<T> of(std::size_t column) const {
    return columns_[column].of<T>();
  }

 private:
  std::vector<NumberBuffer> buffers_;
  std::vector<ByteColumn> columns_;
  char letter_ = '\0';
};

template <Real T>
ElementView viewed_spheres(const Columns& columns, int dimensions) {
  if (dimensions == 2) return ElementView(columns.from<T, 2>(0), columns.of<T>(2));
  return ElementView(columns.from<T, 3>(0), columns.of<T>(3));
}

template <Real T>
ElementView viewed_spheres(const Columns& columns, int dimensions, double radius) {
  if (dimensions == 2) return ElementView(columns.from<T, 2>(0), radius);
  return ElementView(columns.from<T, 3>(0), radius);
}

template <Real T>
ElementView viewed_boxes(const Columns& columns, int dimensions) {
  if (dimensions == 2) return ElementView(columns.from<T, 2>(0), columns.from<T, 2>(2));
  return ElementView(columns.from<T, 3>(0), columns.from<T, 3>(3));
}

int dimensions_of(std::size_t columns) {
  if (columns == 2 || columns == 3) return static_cast<int>(columns);
  throw nb::value_error("2 or 3 coordinates are needed");
}

Elements spheres_in(Columns columns, double radius) {
  const int dimensions = dimensions_of(columns.size());
  const ElementView view = columns.are_float()
                               ? viewed_spheres<float>(columns, dimensions, radius)
                               : viewed_spheres<double>(columns, dimensions, radius);
  return {columns.take_buffers(), view};
}

/// Radii are the last of the columns.
Elements spheres_with_radii_in(Columns columns) {
  const int dimensions = dimensions_of(columns.size() - 1);
  const ElementView view = columns.are_float() ? viewed_spheres<float>(columns, dimensions)
                                               : viewed_spheres<double>(columns, dimensions);
  return {columns.take_buffers(), view};
}

Elements spheres_of(nb::handle centers, double radius) {
  return spheres_in(Columns(centers), radius);
}

Elements spheres_with_radii(nb::handle centers, nb::handle radii) {
  Columns columns(centers);
  const std::size_t coordinates = columns.size();
  columns.add(radii);
  if (columns.size() != coordinates + 1) {
    throw nb::value_error("one radius for each element is needed");
  }
  return spheres_with_radii_in(std::move(columns));
}

/// A buffer of an array of NumPy itself whose numbers can be read where they are: float32 or
/// float64 in this machine's order of bytes, at places that fit the type. None for all others.
std::optional<NumberBuffer> plain_buffer(nb::handle array_type, nb::handle array, int axes) {
  if (array.type().ptr() != array_type.ptr()) return std::nullopt;
  try {
    NumberBuffer buffer(array);
    const char letter = buffer.letter();
    if (buffer.axes() != axes || (letter != 'f' && letter != 'd')) return std::nullopt;
    auto places = reinterpret_cast<std::uintptr_t>(buffer.first());
    for (int axis = 0; axis < axes; ++axis) {
      places |= static_cast<std::uintptr_t>(buffer.stride_bytes(axis));
    }
    if (places % buffer.number_bytes() != 0) return std::nullopt;
    return buffer;
  } catch (const nb::python_error&) {
    return std::nullopt;
  }
}

/// The usual case in one step: elements in plain arrays. None for all others, which the package
/// converts, or it says what is wrong with them.
std::optional<Elements> plain_spheres(nb::handle array_type, nb::handle centers, nb::handle radii) {
  std::optional<NumberBuffer> positions = plain_buffer(array_type, centers, 2);
  if (!positions || (positions->size(1) != 2 && positions->size(1) != 3)) return std::nullopt;
  if (PyFloat_CheckExact(radii.ptr()) != 0) {
    return spheres_in(Columns(std::move(*positions)), nb::cast<double>(radii));
  }
  std::optional<NumberBuffer> numbers = plain_buffer(array_type, radii, 1);
  const bool are_alike =
      numbers && numbers->letter() == positions->letter() && numbers->size(0) == positions->size(0);
  if (!are_alike) return std::nullopt;
  Columns columns(std::move(*positions));
  columns.add(std::move(*numbers));
  return spheres_with_radii_in(std::move(columns));
}

Elements boxes_of(nb::handle lower, nb::handle upper) {
  Columns columns(lower);
  const int dimensions = dimensions_of(columns.size());
  columns.add(upper);
  if (columns.size() != 2 * static_cast<std::size_t>(dimensions)) {
    throw nb::value_error("upper corners of as many coordinates as the lower ones are needed");
  }
  const ElementView view = columns.are_float() ? viewed_boxes<float>(columns, dimensions)
                                               : viewed_boxes<double>(columns, dimensions);
  return {columns.take_buffers(), view};
}

}  // namespace

std::string_view Elements::shape_name() const noexcept {
  if (view_.shape() == Shape::box) return view_.dimensions() == 2 ? "rectangle" : "box";
  return view_.dimensions() == 2 ? "disc" : "sphere";
}

void bind_elements(nb::module_& module) {
  nb::class_<Elements>(module, "Elements",
                       "Elements in arrays of the caller, which are not copied. Made by spheres, "
                       "discs, boxes, rectangles and points.")
      .def("__len__", [](const Elements& elements) { return elements.view().size(); })
      .def_prop_ro(
          "dimensions", [](const Elements& elements) { return elements.view().dimensions(); },
          "Number of dimensions, 2 or 3.")
      .def_prop_ro("shape", &Elements::shape_name, "'sphere', 'disc', 'box' or 'rectangle'.")
      .def_prop_ro(
          "precision",
          [](const Elements& elements) -> std::string_view {
            return elements.view().precision() == Precision::float32 ? "float32" : "float64";
          },
          "'float32' or 'float64': the type of the arrays.");
  module.def("spheres", &spheres_of, nb::arg("centers"), nb::arg("radius"));
  module.def("spheres_with_radii", &spheres_with_radii, nb::arg("centers"), nb::arg("radii"));
  module.def("plain_spheres", &plain_spheres, nb::arg("array_type"), nb::arg("centers"),
             nb::arg("radii").none());
  module.def("boxes", &boxes_of, nb::arg("lower"), nb::arg("upper"));
}

}  // namespace abut::python
