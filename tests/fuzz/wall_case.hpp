#pragma once

#include "fuzz/fuzz_case.hpp"
#include "walls/mesh_oracle.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace abut::fuzz {

/// Spheres beside boxes and, in 3D, beside a mesh.
struct WallCase {
  ElementArrays balls;
  ElementArrays solids;
  testing::MeshArrays mesh;
  std::array<Storage, 2> storage;  ///< of the balls and the solids
  Domain domain = Domain::open();
  double margin = 0.0;
  std::array<std::uint8_t, 8> choices{};  ///< of a form, one for each algorithm
};

/// The case that the bytes describe; none where their domain encloses no cell.
[[nodiscard]] std::optional<WallCase> decode_wall_case(std::span<const std::uint8_t> bytes);

/// Throws Failure where the library differs from the contract, from one algorithm to another, or in
/// what it refuses. False where the case has too many images to be looked at.
bool check_wall_case(const WallCase& given);

[[nodiscard]] std::string dump_wall_case(const WallCase& given);

}  // namespace abut::fuzz
