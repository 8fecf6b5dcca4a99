#pragma once

#include "base/pair_sink.hpp"
#include "kernels/images/image_kernels.hpp"
#include "periodic/images.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::periodic {

/// Turns pairs of locals and ghosts into pairs of elements with their image shifts, and hands them
/// on to another sink. Numbers from the count of locals on are those of ghosts. It keeps its
/// memory.
template <int Dim>
class ImageSink final : public base::PairSink {
 public:
  /// Sink and images must live until the last pairs are committed.
  void start_anew(base::PairSink& next, const Images<Dim>& images,
                  const kernels::ImageKernels& kernels);

  void expect_workers(std::size_t count) override;
  void expect_units(std::uint64_t first, std::size_t count) override {
    next_->expect_units(first, count);
  }
  void begin_unit(const base::Origin& origin) override { next_->begin_unit(origin); }
  void finish_unit(const base::Origin& origin) override { next_->finish_unit(origin); }
  [[nodiscard]] std::span<ContactPair> buffer(std::size_t worker) override;
  void commit(std::size_t count, const base::Origin& origin) override;

 private:
  struct NamedShift {
    std::size_t place;
    ImageShift shift;
  };

  /// A worker's own, on cache lines of its own.
  struct alignas(128) ImageBuffer {
    std::span<ContactPair> pairs;
    std::span<ImageShift> shifts;
    std::vector<NamedShift> of_ghosts;  ///< shifts of pairs with a ghost
  };

  /// Pairs of two ghosts, and of a local element with one that does not count for it, are dropped:
  /// they are found elsewhere, too. Returns how many pairs are left.
  std::size_t name(ImageBuffer& buffer, std::size_t count) const;
  std::size_t keep(std::span<const ContactPair> pairs, ContactPair* to,
                   kernels::BlockList& with_ghost) const;
  std::size_t drop_uncounted(std::span<ContactPair> pairs, kernels::BlockList& with_ghost) const;
  void name_block(ImageBuffer& buffer, std::size_t begin, std::size_t end,
                  const kernels::BlockList& with_ghost) const;
  void name_local(const ImageBuffer& buffer, std::size_t place) const;
  void name_ghost(ImageBuffer& buffer, std::size_t place) const;
  void name_shifts(const ImageBuffer& buffer, std::size_t count) const;
  [[nodiscard]] const Ghost& ghost_of(const ContactPair& pair) const {
    return images_->ghosts()[pair.second - images_->locals().size];
  }

  base::PairSink* next_ = nullptr;
  const Images<Dim>* images_ = nullptr;
  kernels::ImageKernels kernels_{};
  std::vector<ImageBuffer> buffers_;
};

}  // namespace abut::periodic
