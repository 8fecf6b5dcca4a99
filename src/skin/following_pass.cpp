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

namespace abut::skin {
namespace {

constexpr std::size_t elements_at_a_time = 1024;
/// Columns of an element are read one by one.
constexpr std::uint64_t steps_of_reading = 8;

template <int Dim>
class Follower {
 public:
  Follower(const FollowedElements<Dim>& elements, const CallNow& now)
      : elements_(elements), reader_(elements.given), kernels_(kernels::follow_kernels(now.simd)) {}

  /// Follows `count` elements, at most elements_at_a_time, from number `first` on.
  void follow(std::size_t first, std::size_t count, LongestWays& ways) const {
    std::array<double, elements::SphereReader::numbers * elements_at_a_time> room;
    const kernels::ElementColumns columns = reader_.read(first, count, room);
    const exact::Sphere<Dim>* const anchors = elements_.anchors.data() + first;
    const kernels::FollowedSpheres spheres{
        columns, anchors->center, count, elements_.slots.data() + first, elements_.quanta.scale()};
    std::size_t k = ways.widen(
        [&](kernels::LongestTwo& longest) { return kernels_.follow(spheres, Dim, longest); });
    for (; k < count; ++k) {
      const exact::Sphere<Dim> sphere = elements::sphere_at<Dim>(columns, k);
      if (!elements::is_valid(sphere)) return ways.include_unknown();
      ways.include_square(squared_displacement(sphere, anchors[k]),
                          sphere.radius - anchors[k].radius);
      spheres.slots[k] = elements_.quanta.of(sphere);
    }
  }

 private:
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
    const auto [first, last] = base::share_of(share, now.workers, elements.slots.size());
    for (std::size_t k = first; k < last; k += elements_at_a_time) {
      const std::size_t count = std::min(elements_at_a_time, last - k);
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
