#pragma once

#include "base/lattice.hpp"
#include "base/pair_sink.hpp"
#include "base/sphere_predicate.hpp"
#include "grid/images.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace abut::api {

/// What stands behind the numbers of a search over natives and, behind them, ghosts.
template <int Dim>
struct ImageSystem {
  const grid::Images<Dim>& images;
  std::span<const base::Sphere<Dim>> spheres;  ///< as the caller gave them
  const base::Lattice& lattice;
  double margin;
};

/// Turns the pairs that such a search finds into contact pairs with image shifts. Where an element
/// may have been moved the search works with a reach that is a little too long, and the decision is
/// made here, on the caller's numbers. It keeps its rooms.
template <int Dim>
class ImageSink final : public base::PairSink {
 public:
  /// Both must live until the last pairs are committed.
  void start_anew(const ImageSystem<Dim>& system, base::PairSink& target);

  void expect_workers(std::size_t count) override;
  [[nodiscard]] std::span<ContactPair> room(std::size_t worker) override {
    return rooms_[worker]->pairs;
  }
  void commit(std::size_t count, const base::Origin& origin) override;

  /// Of all workers.
  [[nodiscard]] std::uint64_t exact_decisions() const noexcept;

 private:
  struct ImagePair {
    ContactPair pair;
    ImageShift shift;
  };

  struct alignas(128) Room {
    std::array<ContactPair, 2048> pairs;
    std::uint64_t exact_decisions = 0;
  };

  [[nodiscard]] std::optional<ImagePair> contact(ContactPair found, Room& room) const;

  const ImageSystem<Dim>* system_ = nullptr;
  base::PairSink* target_ = nullptr;
  bool all_in_place_ = false;
  std::vector<std::unique_ptr<Room>> rooms_;
};

}  // namespace abut::api
