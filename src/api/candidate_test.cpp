// docs/derivations/skin.md has the bands.

#include "api/candidate_test.hpp"

#include "api/lattice_of.hpp"

#include <algorithm>
#include <cmath>

namespace abut::api {
namespace {

/// Keeps the survivors that `within_reach` confirms.
template <class WithinReach>
void confirm(Survivors& survivors, WithinReach&& within_reach) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < survivors.count; ++k) {
    const std::uint16_t place = survivors.places[k];
    if (within_reach(place)) survivors.places[kept++] = place;
  }
  survivors.count = kept;
}

/// All in doubt.
void take_all(std::size_t count, Survivors& survivors) {
  for (std::size_t k = 0; k < count; ++k) survivors.places[k] = static_cast<std::uint16_t>(k);
  survivors.count = count;
}

/// Asks for the second sphere of a candidate some way ahead. Where numbering does not follow space,
/// each lies elsewhere in memory; asked for in time, it need not be waited for.
template <int Dim>
void fetch_ahead(std::span<const ContactPair> candidates, std::size_t k,
                 std::span<const base::Sphere<Dim>> spheres) {
  constexpr std::size_t ahead = 24;
  const std::size_t next = std::min(k + ahead, candidates.size() - 1);
  __builtin_prefetch(&spheres[candidates[next].second]);
}

/// What a filter says of a candidate; neither of the two where it cannot decide.
struct Verdict {
  bool apart;
  bool together;
};

/// Keeps those that are not certainly apart, without branches. Returns whether some are undecided.
template <class Judge>
bool sift(std::size_t count, Survivors& survivors, Judge&& judge) {
  bool undecided = false;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Verdict verdict = judge(k);
    survivors.places[kept] = static_cast<std::uint16_t>(k);
    kept += verdict.apart ? 0 : 1;
    undecided |= verdict.apart == verdict.together;
  }
  survivors.count = kept;
  return undecided;
}

/// In units of u = 2^-53, of all that is added up: 16.
constexpr double placed_band = 0x1p-49;

}  // namespace

template <int Dim>
OpenCandidateTest<Dim>::OpenCandidateTest(const Snapshot<Dim>& now)
    : spheres_(now.spheres), margin_(now.margin) {
  const double smallest = 2.0 * now.bounds.smallest_radius + margin_;
  const double largest = 2.0 * now.bounds.largest_radius + margin_;
  // A little inside the range, for the rounding of these two.
  in_range_ = smallest * smallest >= 2.0 * base::smallest_safe_square &&
              largest * largest <= 0.5 * base::largest_safe_square;
}

template <int Dim>
void OpenCandidateTest<Dim>::run(std::span<const ContactPair> candidates, Survivors& survivors,
                                 std::uint64_t& exact_decisions) const {
  const bool undecided = sift(in_range_ ? candidates.size() : 0, survivors, [&](std::size_t k) {
    fetch_ahead(candidates, k, spheres_);
    const base::Sphere<Dim>& a = spheres_[candidates[k].first];
    const base::Sphere<Dim>& b = spheres_[candidates[k].second];
    double square = 0.0;
    for (int axis = 0; axis < Dim; ++axis) {
      const double difference = a.center[axis] - b.center[axis];
      square += difference * difference;
    }
    const double reach = a.radius + b.radius + margin_;
    const double reach_square = reach * reach;
    return Verdict{square > reach_square * (1.0 + base::band),
                   square < reach_square * (1.0 - base::band)};
  });
  if (in_range_ && !undecided) return;
  if (!in_range_) take_all(candidates.size(), survivors);
  confirm(survivors, [&](std::size_t k) {
    return base::within_reach(spheres_[candidates[k].first], spheres_[candidates[k].second],
                              margin_, exact_decisions);
  });
}

template <int Dim>
PeriodicCandidateTest<Dim>::PeriodicCandidateTest(const Snapshot<Dim>& now,
                                                  const Displacement<Dim>& placing,
                                                  std::span<const ImageShift> shifts,
                                                  Images& images)
    : spheres_(now.spheres),
      placed_(placing.placed()),
      placing_(placing),
      shifts_(shifts),
      lattice_(lattice_of(now.domain)),
      images_(images),
      margin_(now.margin) {
  images.clear();
  double farthest = 0.0;
  for (const ImageShift& shift : shifts) {
    std::array<double, Dim> image{};
    double magnitude = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      for (std::size_t k = 0; k < Dim; ++k) {
        const double product = base::numbers(shift)[k] * lattice_.vectors[k][axis];
        image[axis] += product;
        magnitude += std::fabs(product);
      }
    }
    images.push_back(image);
    farthest = std::max(farthest, magnitude);
  }
  const double magnitude = 2.0 * placing.magnitude() + farthest + now.largest_reach();
  slack_ = placed_band * magnitude;
  in_range_ =
      magnitude >= base::smallest_safe_magnitude && magnitude <= base::largest_safe_magnitude;
}

template <int Dim>
void PeriodicCandidateTest<Dim>::run(std::span<const ContactPair> candidates,
                                     const std::uint16_t* shift_of, Survivors& survivors,
                                     std::uint64_t& exact_decisions) const {
  const bool undecided = sift(in_range_ ? candidates.size() : 0, survivors, [&](std::size_t k) {
    fetch_ahead(candidates, k, placed_);
    const base::Sphere<Dim>& a = placed_[candidates[k].first];
    const base::Sphere<Dim>& b = placed_[candidates[k].second];
    const std::array<double, Dim>& image = images_[shift_of[k]];
    double square = 0.0;
    for (int axis = 0; axis < Dim; ++axis) {
      const double difference =
          a.center[axis] - b.center[axis] - image[static_cast<std::size_t>(axis)];
      square += difference * difference;
    }
    const double reach = a.radius + b.radius + margin_;
    const double outer = reach + slack_;
    const double inner = std::max(reach - slack_, 0.0);
    return Verdict{square > outer * outer, square < inner * inner};
  });
  if (in_range_ && !undecided) return;
  if (!in_range_) take_all(candidates.size(), survivors);
  confirm(survivors, [&](std::size_t k) {
    const ContactPair pair = candidates[k];
    return base::within_reach(spheres_[pair.first], spheres_[pair.second],
                              this->shift_of(pair, shift_of[k]), lattice_, margin_,
                              exact_decisions);
  });
}

template class OpenCandidateTest<2>;
template class OpenCandidateTest<3>;
template class PeriodicCandidateTest<2>;
template class PeriodicCandidateTest<3>;

}  // namespace abut::api
