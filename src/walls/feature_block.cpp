#include "walls/feature_block.hpp"

#include "exact/cancellation.hpp"

#include <algorithm>
#include <cmath>

namespace abut::walls {
namespace {

bool is_borne(double component) noexcept {
  const double size = std::fabs(component);
  return size == 0.0 || (size >= kernels::smallest_given && size <= exact::largest_input);
}

}  // namespace

FeatureBlock::FeatureBlock(Simd level, const PairGeometrySpans& geometry,
                           const exact::Lattice& lattice) noexcept
    : kernels_(kernels::feature_kernels(level)), geometry_(geometry) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double component = lattice.periodic[k] ? lattice.vectors[k][axis] : 0.0;
      moves_.lattice[k][axis] = component;
      can_move_ = can_move_ && is_borne(component);
    }
  }
}

/// Repeats the last contact until the last vector is full. Returns how many there are then.
std::size_t FeatureBlock::fill_last_vector(int corners) noexcept {
  const std::size_t full = (count_ + most_lanes - 1) / most_lanes * most_lanes;
  const auto fill = [&](auto& column) {
    std::fill(column + count_, column + full, column[count_ - 1]);
  };
  fill(columns_.radius);
  for (auto& column : columns_.center) fill(column);
  for (int corner = 0; corner < corners; ++corner) {
    for (auto& column : columns_.corner[corner]) fill(column);
  }
  for (auto& along : moves_.number) {
    for (auto& column : along) {
      if (is_moved_) fill(column);
    }
  }
  return full;
}

void FeatureBlock::write(std::size_t count) const noexcept {
  const auto write_each = [&](const double(&from)[size], std::span<double> to) {
    for (std::size_t k = 0; k < count && !to.empty(); ++k) to[places_[k]] = from[k];
  };
  const auto write_vectors = [&](const double(&from)[size][3], std::span<Vector> to) {
    for (std::size_t k = 0; k < count && !to.empty(); ++k) {
      to[places_[k]] = {from[k][0], from[k][1], from[k][2]};
    }
  };
  write_each(gaps_, geometry_.gaps);
  write_each(distances_, geometry_.distances);
  write_vectors(normals_, geometry_.normals);
  write_vectors(points_, geometry_.points);
  write_vectors(vectors_, geometry_.vectors);
}

std::span<const std::size_t> FeatureBlock::measure(int corners) noexcept {
  if (count_ == 0) return {};
  if (is_moved_ && !can_move_) return std::span<const std::size_t>(places_).first(count_);
  const kernels::FeatureJob job{&columns_,
                                is_moved_ ? &moves_ : nullptr,
                                fill_last_vector(corners),
                                geometry_.gaps.empty() ? nullptr : gaps_,
                                geometry_.distances.empty() ? nullptr : distances_,
                                geometry_.normals.empty() ? nullptr : normals_,
                                geometry_.points.empty() ? nullptr : points_,
                                geometry_.vectors.empty() ? nullptr : vectors_};
  std::size_t open_count = 0;
  const std::size_t treated =
      std::min(count_, kernels_.measure(job, corners, open_.data(), open_count));
  write(treated);
  std::size_t left = 0;
  for (std::size_t k = 0; k < open_count && open_[k] < count_; ++k) {
    open_places_[left++] = places_[open_[k]];
  }
  for (std::size_t k = treated; k < count_; ++k) open_places_[left++] = places_[k];
  return std::span<const std::size_t>(open_places_).first(left);
}

}  // namespace abut::walls
