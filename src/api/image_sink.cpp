#include "api/image_sink.hpp"

#include "base/periodic_predicate.hpp"

#include <algorithm>
#include <utility>

namespace abut::api {
namespace {

constexpr ImageShift opposite(const ImageShift& shift) noexcept {
  return {-shift.x, -shift.y, -shift.z};
}

}  // namespace

template <int Dim>
void ImageSink<Dim>::start_anew(const ImageSystem<Dim>& system, base::PairSink& target) {
  system_ = &system;
  target_ = &target;
  all_in_place_ = system.images.natives().data() == system.spheres.data();
  for (const auto& room : rooms_) room->exact_decisions = 0;
}

template <int Dim>
void ImageSink<Dim>::expect_workers(std::size_t count) {
  target_->expect_workers(count);
  while (rooms_.size() < count) rooms_.push_back(std::make_unique<Room>());
}

template <int Dim>
void ImageSink<Dim>::commit(std::size_t count, const base::Origin& origin) {
  Room& room = *rooms_[origin.worker];
  auto pairs = target_->room(origin.worker);
  auto shifts = target_->shift_room(origin.worker);
  std::size_t filled = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::optional<ImagePair> contact = this->contact(room.pairs[k], room);
    if (!contact) continue;
    if (filled == pairs.size()) {
      target_->commit(filled, origin);
      pairs = target_->room(origin.worker);
      shifts = target_->shift_room(origin.worker);
      filled = 0;
    }
    pairs[filled] = contact->pair;
    if (!shifts.empty()) shifts[filled] = contact->shift;
    ++filled;
  }
  if (filled > 0) target_->commit(filled, origin);
}

/// The numbers of natives are those of their elements; ghosts follow.
template <int Dim>
auto ImageSink<Dim>::contact(ContactPair found, Room& room) const -> std::optional<ImagePair> {
  const auto& [images, spheres, lattice, margin] = *system_;
  const auto [first, last] = std::minmax(found.first, found.second);
  if (first >= spheres.size()) return std::nullopt;  // ghosts do not pair with ghosts
  ImagePair pair{{first, last}, {}};
  if (last < spheres.size()) {
    if (all_in_place_) return pair;
    pair.shift = images.shift_between(first, last);
  } else {
    const grid::Ghost& ghost = images.ghosts()[last - spheres.size()];
    pair.pair.second = ghost.element;
    pair.shift = images.shift_between(first, ghost);
  }
  if (!base::within_reach(spheres[pair.pair.first], spheres[pair.pair.second], pair.shift, lattice,
                          margin, room.exact_decisions)) {
    return std::nullopt;
  }
  if (pair.pair.first > pair.pair.second) {
    std::swap(pair.pair.first, pair.pair.second);
    pair.shift = opposite(pair.shift);
  } else if (pair.pair.first == pair.pair.second && pair.shift < ImageShift{}) {
    pair.shift = opposite(pair.shift);
  }
  return pair;
}

template <int Dim>
std::uint64_t ImageSink<Dim>::exact_decisions() const noexcept {
  std::uint64_t sum = 0;
  for (const auto& room : rooms_) sum += room->exact_decisions;
  return sum;
}

template class ImageSink<2>;
template class ImageSink<3>;

}  // namespace abut::api
