#include "geometry/spans.hpp"

#include <abut/error.hpp>

#include <cstdint>
#include <string>

namespace abut::geometry {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorCode::wrong_usage, what);
}

}  // namespace

void require_lengths(std::size_t count, const char* of_what, std::span<const ImageShift> shifts,
                     const PairGeometrySpans& geometry) {
  const auto require = [&](std::size_t length, const char* what) {
    if (length == 0 || length == count) return;
    refuse("the array of " + std::string(what) + " has " + std::to_string(length) +
           " entries, but there are " + std::to_string(count) + " " + of_what +
           "; give one entry for each");
  };
  require(shifts.size(), "image shifts");
  require(geometry.gaps.size(), "gaps");
  require(geometry.normals.size(), "normals");
  require(geometry.points.size(), "points");
  require(geometry.distances.size(), "distances");
  require(geometry.vectors.size(), "vectors");
}

void require_shifts(std::size_t count, const char* of_what, std::span<const ImageShift> shifts,
                    const Domain& domain) {
  if (domain.is_periodic() && shifts.empty() && count > 0) {
    refuse(std::string(of_what) +
           " of a periodic domain without image shifts; set Options::shifts to Shifts::stored when "
           "they are found");
  }
  ImageShift used;
  for (const ImageShift& shift : shifts) {
    used = {used.x | shift.x, used.y | shift.y, used.z | shift.z};
  }
  const std::int32_t numbers[3] = {used.x, used.y, used.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (numbers[axis] == 0 || domain.is_periodic(axis)) continue;
    refuse(std::string("an image shift along ") + "xyz"[axis] +
           " is not 0, but the domain is not periodic there");
  }
}

PairGeometry arrays_for(std::size_t count, Quantities wanted) {
  const auto count_if = [&](Quantity quantity) { return wanted.has(quantity) ? count : 0; };
  PairGeometry geometry;
  geometry.gaps.resize(count_if(Quantity::gap));
  geometry.normals.resize(count_if(Quantity::normal));
  geometry.points.resize(count_if(Quantity::point));
  geometry.distances.resize(count_if(Quantity::distance));
  geometry.vectors.resize(count_if(Quantity::vector));
  return geometry;
}

Quantities wanted_by(const PairGeometrySpans& geometry) noexcept {
  Quantities wanted;
  if (!geometry.gaps.empty()) wanted = wanted | Quantity::gap;
  if (!geometry.normals.empty()) wanted = wanted | Quantity::normal;
  if (!geometry.points.empty()) wanted = wanted | Quantity::point;
  if (!geometry.distances.empty()) wanted = wanted | Quantity::distance;
  if (!geometry.vectors.empty()) wanted = wanted | Quantity::vector;
  return wanted;
}

}  // namespace abut::geometry
