#include "skin/following_pass.hpp"

#include "base/asking_workers.hpp"
#include "elements/sphere_reader.hpp"
#include "elements/valid_element.hpp"
#include "kernels/follow_kernels.hpp"
#include "skin/longest_ways.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>

namespace abut::skin {
namespace {

constexpr std::size_t elements_at_a_time = 1024;
/// Of those that go to slots anywhere: what workers with a small stack have room for.
constexpr std::size_t scattered_at_a_time = 512;
/// Slots that lie anywhere in memory are asked for so many elements ahead.
constexpr std::size_t elements_ahead = 64;
/// Columns of an element are read one by one.
constexpr std::uint64_t steps_of_reading = 8;

template <int Dim>
class Follower {
 public:
  Follower(const FollowedElements<Dim>& elements, const CallNow& now)
      : elements_(elements), reader_(elements.given), kernels_(kernels::follow_kernels(now.simd)) {}

  [[nodiscard]] std::size_t most() const noexcept {
    return elements_.slot_of == nullptr ? elements_at_a_time : scattered_at_a_time;
  }

  /// Follows `count` elements, at most most(), from number `first` on.
  void follow(std::size_t first, std::size_t count, LongestWays& ways) const {
    if (elements_.slot_of == nullptr) {
      return fill(first, count, elements_.slots.data() + first, ways);
    }
    std::array<kernels::QuantumSphere, scattered_at_a_time> filled;
    fill(first, count, filled.data(), ways);
    if (ways.known()) scatter(first, std::span(filled).first(count));
  }

 private:
  void fill(std::size_t first, std::size_t count, kernels::QuantumSphere* slots,
            LongestWays& ways) const {
    std::array<double, elements::SphereReader::numbers * elements_at_a_time> room;
    const kernels::ElementColumns columns = reader_.read(first, count, room);
    const exact::Sphere<Dim>* const anchors = elements_.anchors.data() + first;
    const kernels::FollowedSpheres spheres{columns, anchors->center, count, slots,
                                           elements_.quanta.scale()};
    std::size_t k = ways.widen(
        [&](kernels::LongestTwo& longest) { return kernels_.follow(spheres, Dim, longest); });
    for (; k < count; ++k) {
      const exact::Sphere<Dim> sphere = elements::sphere_at<Dim>(columns, k);
      if (!elements::is_valid(sphere)) return ways.include_unknown();
      ways.include_square(squared_displacement(sphere, anchors[k]),
                          sphere.radius - anchors[k].radius);
      slots[k] = elements_.quanta.of(sphere);
    }
  }

  void scatter(std::size_t first, std::span<const kernels::QuantumSphere> filled) const {
    const std::span<const std::uint32_t> slot_of(elements_.slot_of, elements_.anchors.size());
    const std::span<kernels::QuantumSphere> slots = elements_.slots;
    for (std::size_t k = first; k < first + filled.size(); ++k) {
      const std::uint32_t next = slot_of[std::min(k + elements_ahead, slot_of.size() - 1)];
      __builtin_prefetch(slots.data() + std::min<std::size_t>(next, slots.size()), 1);
      if (slot_of[k] < slots.size()) slots[slot_of[k]] = filled[k - first];
    }
  }

  const FollowedElements<Dim>& elements_;
  elements::SphereReader reader_;
  kernels::FollowKernels kernels_;
};

}  // namespace

template <int Dim>
double follow(const FollowedElements<Dim>& elements, const CallNow& now, double allowed) {
  const Follower<Dim> follower(elements, now);
  LongestWays all;
  std::mutex mutex;
  base::for_each_share(now.workers, now.work, [&](std::size_t share, base::WorkCounter& work) {
    LongestWays own;
    const auto [first, last] = base::share_of(share, now.workers, elements.anchors.size());
    for (std::size_t k = first; k < last; k += follower.most()) {
      const std::size_t count = std::min(follower.most(), last - k);
      follower.follow(k, count, own);
      if (!own.known() || own.longest() > allowed) break;
      work.did(steps_of_reading * count);
    }
    const std::lock_guard lock(mutex);
    all.include(own);
  });
  const double approach = all.sum_of_two() * (1.0 + kernels::displacement_band);
  return approach <= allowed ? approach : std::numeric_limits<double>::infinity();
}

template double follow(const FollowedElements<2>&, const CallNow&, double);
template double follow(const FollowedElements<3>&, const CallNow&, double);

}  // namespace abut::skin
