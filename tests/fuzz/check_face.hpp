#pragma once

#include "fuzz/question.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace abut::fuzz {

/// A form in which the contacts are asked for.
enum class Face : std::uint8_t {
  canonical_list,
  as_found_list,
  list_without_shifts,
  limited_list,  ///< with max_pairs at the number of pairs, and one below
  count,
  batches,
  shifted_batches,
  half_neighbors,
  full_neighbors,
};

inline constexpr std::array<Face, 9> all_faces{
    Face::canonical_list,  Face::as_found_list,  Face::list_without_shifts,
    Face::limited_list,    Face::count,          Face::batches,
    Face::shifted_batches, Face::half_neighbors, Face::full_neighbors};

[[nodiscard]] const char* name_of(Face face);

/// Throws Failure where the answer is not the one expected, and what the library throws.
void check_face(Face face, const FreeFunctions& source);
void check_face(Face face, const AskedDetector& source);

}  // namespace abut::fuzz
