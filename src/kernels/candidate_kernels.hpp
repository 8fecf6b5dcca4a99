#pragma once

#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// A sphere or disc in whole quanta of length: where it is and how large, off by less than 1 in
/// each number. An image is what is taken off a difference of two: the lattice vector, and the
/// margin, negative.
struct QuantumSphere {
  std::int32_t center[3];  ///< the third is 0 in 2D
  std::int32_t radius;
};

/// A candidate pair by the slots of its elements.
struct SlotPair {
  std::uint32_t first;
  std::uint32_t second;
};

/// Candidates in words of 64, all full.
struct CandidateWords {
  const SlotPair* pairs;
  const QuantumSphere* slots;
  const QuantumSphere* images;
  const std::uint16_t* image_of;  ///< of each candidate; null in open space: the one image's
                                  ///< lattice vector is 0
  std::size_t count;              ///< of words
  std::size_t fetchable;          ///< words from here on, where a cache does not hold all slots
};

/// Answers of the filter for a word of candidates, one bit for each.
struct CandidateVerdict {
  std::uint64_t together;
  std::uint64_t left_undecided;
};

/// A distance, and a reach, may be off by so many quanta, all errors of both together.
inline constexpr float quantum_slack = 16.0f;
/// Relative band of the squares, for the roundings of floats: 16 of 2^-24.
inline constexpr float square_band = 0x1p-20f;

/// How lengths become whole quanta: coordinates less `middle`, and radii, times `per_length`, no
/// farther from 0 than `most`, rounded towards it.
struct QuantumScale {
  double middle[4];  ///< of radii 0
  double per_length;
  double most;
};

/// Spheres (four doubles each) to be seen in quanta.
struct QuantumFilling {
  const double* spheres;
  const std::uint32_t* numbers;  ///< of the spheres of the slots; null for one after the other
  std::size_t count;
  QuantumSphere* slots;
  QuantumScale scale;
};

/// What was copied of some words of candidates.
struct KeptCandidates {
  std::size_t words;  ///< treated
  std::size_t pairs;  ///< kept
};

struct CandidateKernels {
  /// Returns how many words were decided; the others are the caller's, who has the same in plain
  /// C++: with d = first - second - image, all in 32 bits, and w = the sum of the radii + 1 -
  /// image.radius, the square of |d| is compared with those of w + slack and w - slack.
  std::size_t (*sift)(const CandidateWords& words, CandidateVerdict* verdicts);

  /// Returns how many slots were filled, likewise.
  std::size_t (*fill)(const QuantumFilling& filling);

  /// Copies those pairs of `words` words of 64, all full, whose bits are set, in order. `kept` has
  /// room for all of them; what is not kept there may be overwritten.
  KeptCandidates (*keep)(const SlotPair* pairs, const std::uint64_t* bits, std::size_t words,
                         ContactPair* kept);
};

/// `level` must be available.
[[nodiscard]] CandidateKernels candidate_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] CandidateKernels simd_candidate_kernels(std::int64_t target);

}  // namespace abut::kernels
