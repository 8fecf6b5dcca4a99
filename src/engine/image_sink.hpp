#pragma once

#include "base/pair_sink.hpp"
#include "engine/images.hpp"
#include "kernels/image_kernels.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace abut::engine {

/// Turns pairs of natives and ghosts into pairs of elements with their image shifts, and hands them
/// on to another sink. Numbers from the count of natives on are those of ghosts. It keeps its
/// memory.
template <int Dim>
class ImageSink final : public base::PairSink {
 public:
  /// Sink and images must live until the last pairs are committed.
  void start_anew(base::PairSink& next, const Images<Dim>& images,
                  const kernels::ImageKernels& kernels);

  void expect_workers(std::size_t count) override;
  [[nodiscard]] std::span<ContactPair> room(std::size_t worker) override;
  void commit(std::size_t count, const base::Origin& origin) override;

 private:
  /// A worker's own, on cache lines of its own.
  struct alignas(128) Room {
    std::span<ContactPair> pairs;
    std::span<ImageShift> shifts;
  };

  /// Pairs of two ghosts, and of a native with one that does not count for it, are dropped: they
  /// are found elsewhere, too. Returns how many pairs are left.
  std::size_t name(const Room& room, std::size_t count) const;
  [[nodiscard]] std::size_t first_with_ghost(std::span<const ContactPair> pairs) const;
  void name_natives(const Room& room, std::size_t begin, std::size_t end, std::size_t to) const;
  bool name_ghost(const Room& room, std::size_t from, std::size_t to) const;

  base::PairSink* next_ = nullptr;
  const Images<Dim>* images_ = nullptr;
  kernels::ImageKernels kernels_{};
  std::vector<Room> rooms_;
};

}  // namespace abut::engine
