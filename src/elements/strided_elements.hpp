#pragma once

#include "kernels/strided_boxes.hpp"
#include "kernels/strided_spheres.hpp"

#include <abut/element_view.hpp>

#include <optional>

namespace abut::elements {

/// The caller's spheres or discs where they lie, if their numbers are doubles that can be read as
/// such. A common radius is read from `common_radius`, which must outlive the result.
[[nodiscard]] std::optional<kernels::StridedSpheres> strided_spheres(const ElementView& spheres,
                                                                     const double* common_radius);

/// The same of boxes or rectangles.
[[nodiscard]] std::optional<kernels::StridedBoxes> strided_boxes(const ElementView& boxes);

}  // namespace abut::elements
