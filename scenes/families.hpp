#pragma once

#include "scenes/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The makers behind the table of scene.cpp, and what they share.
namespace abut::scenes {

/// Throws Error{limit_exceeded} for more elements than there are numbers or memory.
void require_possible(std::size_t count);

/// A scene without elements and with room for `count`. Throws Error{limit_exceeded} if there is
/// none.
[[nodiscard]] Scene empty_scene(int dimensions, std::size_t count);

void add_disc(Scene& scene, double x, double y, double radius);
void add_sphere(Scene& scene, double x, double y, double z, double radius);

/// Numbers the elements anew, at random.
void shuffle(Scene& scene, std::uint64_t seed);

/// Element k of the result is element `order[k]` of the scene.
[[nodiscard]] Scene reordered(const Scene& scene, const std::vector<std::size_t>& order);

/// The smallest n with n^dimensions >= count.
[[nodiscard]] std::size_t side_of(std::size_t count, int dimensions);

[[nodiscard]] Scene make_pack_1(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_pack_2(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_pack_3(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_pack_4(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_hexagonal_2d(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_dense(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_dense_spread(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_dense_stray(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_boulders(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_ordered(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_gas_2d(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_gas(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_sparse(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_clusters(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_clusters_100(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_clusters_30(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_two_far_clusters(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_shell(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_graded_by_place(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_crowds(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_refined(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_sph(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_sph_lattice(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_bidisperse(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_polydisperse(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_log_uniform(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_log_uniform_1000(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_graded(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_graded_1000(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_one_giant(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_touching_cubic(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_touching_fcc(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_touching_cubic_shuffled(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_touching_fcc_shuffled(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_coincident(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_line(std::size_t count, std::uint64_t seed);

[[nodiscard]] Scene make_near_faces_2d(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_near_faces(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_near_faces_float32_2d(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_near_faces_float32(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_at_reach_2d(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene make_at_reach(std::size_t count, std::uint64_t seed);

}  // namespace abut::scenes
