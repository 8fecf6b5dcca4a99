#include "walls/feature_search.hpp"

#include "base/callers_exception.hpp"
#include "base/stopwatch.hpp"
#include "detect/detection_request.hpp"
#include "detect/pair_search.hpp"
#include "detect/validate_options.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/lattice_of.hpp"
#include "kernels/simd_level.hpp"
#include "lattice/check_range.hpp"
#include "lists/order_pairs.hpp"
#include "walls/box_cover.hpp"
#include "walls/box_view.hpp"

#include <abut/error.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <string>

namespace abut::walls {
namespace {

/// Returns an upper bound of the sum that was rounded to x: at least the next double, or x itself
/// where the sum is subnormal and thus exact.
double upwards(double x) noexcept {
  return x + std::fabs(x) * 0x1p-52;
}

double finite(double x) noexcept {
  return std::min(x, std::numeric_limits<double>::max());
}

/// True if some lattice vector has a component along the axis.
bool leads_along(const Domain& domain, int axis) noexcept {
  for (int k = 0; k < 3; ++k) {
    if (domain.vector(k)[static_cast<std::size_t>(axis)] != 0.0) return true;
  }
  return false;
}

}  // namespace

template <int Dim>
exact::Box<Dim> box_around(const exact::Sphere<Dim>& sphere, double margin) noexcept {
  exact::Box<Dim> box{};
  const double reach = upwards(sphere.radius + margin);  // may be infinite
  for (int axis = 0; axis < Dim; ++axis) {
    box.lower[axis] = -finite(upwards(reach - sphere.center[axis]));
    box.upper[axis] = finite(upwards(reach + sphere.center[axis]));
  }
  return box;
}

void require_allowed(PairCount contacts, const Options& options) {
  if (contacts <= options.max_pairs) return;
  throw Error(ErrorCode::limit_exceeded, "there are " + std::to_string(contacts) +
                                             " contacts, and the limit that was set is " +
                                             std::to_string(options.max_pairs) + "; raise it");
}

template <int Dim>
FeatureSearch<Dim>::FeatureSearch(const ElementView& spheres, const ElementView& boxes,
                                  const Domain& domain, const Options& options)
    : options_(options),
      elements_(spheres.size() + boxes.size()),
      workers_(base::worker_count(options.threads, elements_)),
      memory_(detect::memory_bound(options)),
      context_(memory_, options.progress),
      spheres_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory_, 0)),
      near_(base::make_array_for_overwrite<ElementIndex>(memory_, 0)),
      candidates_(base::make_array_for_overwrite<ContactPair>(memory_, 0)),
      shifts_(base::make_array_for_overwrite<ImageShift>(memory_, 0)) {
  base::letting_through([&] {
    base::reporting_lack_of_memory(memory_, [&] {
      detect::validate(options, spheres, domain);
      gather(spheres);
      leave_out_far(boxes, domain);
      try {
        find_candidates(boxes, domain);
      } catch (const Error& error) {
        if (error.code() != ErrorCode::invalid_input || !domain.is_periodic()) throw;
        // Too far out: said of the sphere rather than of the box around it, and by the caller's
        // numbers.
        lattice::check_range_as_given<Dim>(spheres_, elements::lattice_of(domain), options.margin,
                                           Shape::sphere);
        if (near_.size() == spheres_.size()) throw;
        keep_all();
        find_candidates(boxes, domain);
      }
    });
  });
}

/// Searches within this call: with its memory meter, its hook and its guards.
template <int Dim>
void FeatureSearch<Dim>::find_candidates(const ElementView& boxes, const Domain& domain) {
  const base::Array<exact::Box<Dim>> around = boxes_around();
  const ElementView view = view_of<Dim>(around);
  const Options options = options_of_search(domain);
  const detect::DetectionRequest request{view, domain, options, &boxes};
  detect::validate_request(request);
  lists::FoundPairs found(memory_);
  found.start_anew({.shifts = options.shifts, .order = Order::canonical});
  statistics_ = std::make_unique<detect::PairSearch>(memory_)->find(request, found, context_);
  order_candidates(found);
}

template <int Dim>
void FeatureSearch<Dim>::order_candidates(lists::FoundPairs& found) {
  context_.progress.begin("order", found.size());
  base::Stopwatch stopwatch;
  const lists::FoundPieces pieces = found.pieces();
  candidates_.resize(found.size());
  shifts_.resize(pieces.shifts.empty() ? 0 : found.size());
  const lists::OutputBuffer target{candidates_, shifts_};
  const auto workers = static_cast<std::size_t>(statistics_.threads);
  lists::PairOrder order(memory_);
  order.sort(pieces, near_.size(), target, workers, context_.work);
  statistics_.order_seconds = stopwatch.lap();
}

template <int Dim>
void FeatureSearch<Dim>::gather(const ElementView& spheres) {
  elements::GatheredElements<Dim> gathered(memory_);
  context_.progress.begin("gather", spheres.size());
  elements::gather<Dim>(spheres, {workers_, kernels::level_to_run(options_.simd)}, gathered,
                        context_);
  spheres_ = std::move(gathered.spheres);
}

template <int Dim>
void FeatureSearch<Dim>::keep_all() {
  near_.resize(spheres_.size());
  std::iota(near_.begin(), near_.end(), ElementIndex{0});
}

/// Leaves out spheres that are far from all boxes: a search of two sets also meets the pairs within
/// each set, which would cost time for nothing. All spheres stay if there is a rule, since a rule
/// knows elements by their numbers. With a lattice, only axes without a component of a lattice
/// vector can tell: along these, images lie where the boxes themselves lie.
template <int Dim>
void FeatureSearch<Dim>::leave_out_far(const ElementView& boxes, const Domain& domain) {
  if (!options_.rule.is_empty()) return keep_all();
  near_.resize(spheres_.size());
  BoxCover<Dim> cover(boxes, workers_, context_.work);
  for (int axis = 0; axis < Dim; ++axis) {
    if (leads_along(domain, axis)) cover.extend(axis);
  }
  std::vector<std::size_t> counts(workers_);
  base::for_each_share(workers_, context_.work, [&](std::size_t worker, base::WorkCounter& work) {
    const auto [first, last] = base::share_of(worker, workers_, spheres_.size());
    std::size_t end = first;
    for (std::size_t k = first; k < last; ++k) {
      work.did(1 + cover.size());
      near_[end] = static_cast<ElementIndex>(k);
      end += cover.meets(box_around<Dim>(spheres_[k], options_.margin)) ? 1 : 0;
    }
    counts[worker] = end - first;
  });
  auto end = near_.begin();
  for (std::size_t worker = 0; worker < workers_; ++worker) {
    const auto first = near_.begin() + static_cast<std::ptrdiff_t>(
                                           base::share_of(worker, workers_, spheres_.size()).first);
    const auto count = static_cast<std::ptrdiff_t>(counts[worker]);
    end = first == end ? end + count : std::copy(first, first + count, end);
  }
  near_.erase(end, near_.end());
}

template <int Dim>
base::Array<exact::Box<Dim>> FeatureSearch<Dim>::boxes_around() {
  auto boxes = base::make_array_for_overwrite<exact::Box<Dim>>(memory_, near_.size());
  base::for_each_share(workers_, context_.work, [&](std::size_t share, base::WorkCounter& work) {
    const auto [first, last] = base::share_of(share, workers_, near_.size());
    for (std::size_t k = first; k < last; ++k) {
      work.did(4);
      boxes[k] = box_around<Dim>(spheres_[near_[k]], options_.margin);
    }
  });
  return boxes;
}

/// Returns the options of the search, without the margin, which is in the boxes.
template <int Dim>
Options FeatureSearch<Dim>::options_of_search(const Domain& domain) const {
  return {.algorithm = options_.algorithm,
          .shifts = domain.is_periodic() ? Shifts::stored : Shifts::none,
          .rule = options_.rule,
          .max_bytes = options_.max_bytes,
          .threads = options_.threads,
          .simd = options_.simd};
}

template <int Dim>
std::size_t FeatureSearch<Dim>::end_of_sphere(std::size_t place) const {
  const std::span<const ContactPair> pairs(candidates_);
  const ElementIndex sphere = pairs[place].first;
  while (place < pairs.size() && pairs[place].first == sphere) ++place;
  return place;
}

template <int Dim>
std::pair<std::size_t, std::size_t> FeatureSearch<Dim>::share_of(std::size_t worker) const {
  const std::size_t size = candidates_.size();
  // A sphere is the worker's in whose share its first candidate lies.
  const auto moved = [&](std::size_t place) {
    return place == 0 || place == size ? place : end_of_sphere(place - 1);
  };
  const auto share = base::share_of(worker, workers_, size);
  return {moved(share.first), moved(share.second)};
}

template exact::Box<2> box_around(const exact::Sphere<2>&, double) noexcept;
template exact::Box<3> box_around(const exact::Sphere<3>&, double) noexcept;
template class FeatureSearch<2>;
template class FeatureSearch<3>;

}  // namespace abut::walls
