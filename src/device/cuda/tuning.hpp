#pragma once

namespace abut::device {

template <class Given, class Ghosts>
struct PeriodicElements;

/// Threads of a block. Not measured yet: no device has run this.
inline constexpr unsigned threads_of_block = 256;
/// Whether a body computes positions of periodic images.
template <class Body>
inline constexpr bool has_images = false;
template <class Given, class Ghosts>
inline constexpr bool has_images<PeriodicElements<Given, Ghosts>> = true;
template <template <class...> class Body, class... Parts>
inline constexpr bool has_images<Body<Parts...>> = (has_images<Parts> || ...);

/// Blocks that fit into a multiprocessor at once, at least: no more than 80 registers a thread, or
/// 128.
template <class Body>
inline constexpr unsigned blocks_at_once = has_images<Body> ? 2 : 3;
/// More items than blocks of threads are taken in strides.
inline constexpr unsigned most_blocks = 1U << 20;
/// Blocks that keep numbers of classes in shared memory: each adds them to those of all in the end.
inline constexpr unsigned blocks_of_classes = 1U << 11;
/// Threads that a reduction begins with, and results that are left to the host.
inline constexpr unsigned parts_of_reduction = 1U << 17;
inline constexpr unsigned parts_on_host = 128;

}  // namespace abut::device
