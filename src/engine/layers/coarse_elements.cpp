#include "engine/layers/coarse_elements.hpp"

#include "base/asking_workers.hpp"
#include "engine/layers/large_elements.hpp"
#include "grid/kernel_bounds.hpp"

#include <algorithm>

namespace abut::engine {
namespace {

/// Elements that take as long to copy as a thread takes to wake.
constexpr std::size_t worth_a_worker = 512;

}  // namespace

template <int Dim>
CoarseElements<Dim>::CoarseElements(base::MemoryMeter& memory)
    : memory_(memory),
      numbers_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      spheres_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      boxes_(base::make_array_for_overwrite<exact::Box<Dim>>(memory, 0)) {}

template <int Dim>
void CoarseElements<Dim>::take(const LayerSpheres<Dim>& all, double cut,
                               const kernels::ElementKernels& kernels, std::size_t workers,
                               base::WorkCounter& work) {
  make_shares(workers);
  base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    CoarseShare& share = shares_[worker];
    share.numbers.clear();
    share.others = {};
    const auto [first, last] = base::share_of(worker, workers, all.size());
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for_each_block_with_large(
          all, cut, begin, end,
          [&](std::size_t block, std::size_t block_end, std::span<const std::uint32_t> coarse) {
            take_block(all, kernels, {block, block_end}, coarse, share);
          });
    });
  });
  join_shares(all, workers);
  copy(all, workers, work);
}

template <int Dim>
void CoarseElements<Dim>::make_shares(std::size_t workers) {
  while (shares_.size() < workers) {
    shares_.push_back({base::make_array_for_overwrite<std::uint32_t>(memory_, 0), {}});
  }
}

template <int Dim>
void CoarseElements<Dim>::take_block(const LayerSpheres<Dim>& all,
                                     const kernels::ElementKernels& kernels, const Block& block,
                                     std::span<const std::uint32_t> coarse, CoarseShare& share) {
  std::size_t begin = block.begin;
  for (const std::uint32_t number : coarse) {
    share.numbers.push_back(number);
    include(all, kernels, {begin, number}, share.others);
    begin = std::size_t{number} + 1;
  }
  include(all, kernels, {begin, block.end}, share.others);
}

/// Widens bounds by elements that are not coarse.
template <int Dim>
void CoarseElements<Dim>::include(const LayerSpheres<Dim>& all,
                                  const kernels::ElementKernels& kernels, const Block& block,
                                  grid::Bounds<Dim>& bounds) {
  for (const auto& some : all.given().some(block.begin, block.end)) {
    std::size_t k = some.begin;
    if (all.have_radii()) {
      k += grid::widen(bounds, [&](kernels::ElementBounds& packed) {
        return kernels.check(some.columns, some.begin, some.end - some.begin, Dim, packed);
      });
    }
    for (; k < some.end; ++k) {
      bounds.include_center(kernels::sphere_at<Dim>(some.columns, k));
      bounds.include_radius(all.radius(some.number_of_first + k));
    }
  }
}

template <int Dim>
void CoarseElements<Dim>::join_shares(const LayerSpheres<Dim>& all, std::size_t workers) {
  numbers_.clear();
  others_ = {};
  for (const CoarseShare& share : std::span(shares_).first(workers)) {
    numbers_.insert(numbers_.end(), share.numbers.begin(), share.numbers.end());
    others_.include(share.others);
  }
  if (all.stand_for_boxes()) others_.count_largest_twice();
}

template <int Dim>
void CoarseElements<Dim>::take(const LayerSpheres<Dim>& all, std::span<const std::uint32_t> numbers,
                               std::size_t workers, base::WorkCounter& work) {
  numbers_.clear();
  numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
  make_shares(workers);
  copy(all, workers, work);
}

/// Copies those whose numbers are there.
template <int Dim>
void CoarseElements<Dim>::copy(const LayerSpheres<Dim>& all, std::size_t workers,
                               base::WorkCounter& work) {
  const std::size_t count = numbers_.size();
  spheres_.clear();
  spheres_.resize(count);
  boxes_.clear();
  if (all.stand_for_boxes()) boxes_.resize(count);
  const std::size_t sharing = base::workers_worth(count, worth_a_worker, workers);
  base::for_each_share(sharing, work, [&](std::size_t worker, base::WorkCounter& its_work) {
    double& largest = shares_[worker].largest_radius;
    largest = 0.0;
    const auto [first, last] = base::share_of(worker, sharing, count);
    its_work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      copy_some(all, begin, end, largest);
    });
  });
  largest_radius_ = 0.0;
  for (const CoarseShare& share : std::span(shares_).first(sharing)) {
    largest_radius_ = std::max(largest_radius_, share.largest_radius);
  }
}

template <int Dim>
void CoarseElements<Dim>::copy_some(const LayerSpheres<Dim>& all, std::size_t begin,
                                    std::size_t end, double& largest_radius) {
  for (std::size_t k = begin; k < end; ++k) {
    const std::uint32_t number = numbers_[k];
    spheres_[k] = all[number];
    spheres_[k].radius = all.radius(number);
    largest_radius = std::max(largest_radius, spheres_[k].radius);
    if (all.stand_for_boxes()) boxes_[k] = kernels::box_at<Dim>(all.boxes(), number);
  }
}

template class CoarseElements<2>;
template class CoarseElements<3>;

}  // namespace abut::engine
