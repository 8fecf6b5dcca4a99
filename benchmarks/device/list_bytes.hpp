#pragma once

#include "scenes/scene.hpp"

#include <cstdint>
#include <optional>

namespace abut::benchmarks {

/// The forms of a result that are measured.
enum class ResultForm { count, pairs, half_list, full_list };

/// How radii are given: one for all, a column of equal ones, or others.
enum class RadiiGiven { once, equal_in_column, different };

/// A detection, as far as the bytes that it reads and writes follow from it.
struct DetectionSize {
  ResultForm form = ResultForm::pairs;
  std::uint64_t elements = 0;
  std::uint64_t pairs = 0;
  std::uint64_t exact_decisions = 0;
  int dimensions = 3;
  RadiiGiven radii = RadiiGiven::once;
  bool has_gaps = false;
  bool has_shifts = false;
  bool is_periodic = false;
};

/// That of a scene in open space, without its pairs.
[[nodiscard]] DetectionSize size_of(const scenes::Scene& scene);

/// Bytes that no engine can do without: elements read once, the result written once.
[[nodiscard]] double compulsory_bytes(const DetectionSize& size);

/// Bytes that the stages of the device engine read and write at least, stage by stage as
/// src/device/pipeline.hpp strings them together. A read at a random place counts a sector of 32
/// bytes. None in a periodic domain, for no statistics tell the number of ghosts, and none where
/// radii differ, for the number of levels and what they visit is not told either.
[[nodiscard]] std::optional<double> moved_bytes(const DetectionSize& size);

}  // namespace abut::benchmarks
