#include <abut/measure.hpp>

#include "base/callers_exception.hpp"
#include "base/detection_context.hpp"
#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/workers.hpp"
#include "detect/validate_options.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/lattice_of.hpp"
#include "geometry/measure_pairs.hpp"
#include "geometry/spans.hpp"
#include "kernels/simd_level.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace abut {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorCode::wrong_usage, what);
}

void require_lengths(const PairSpans& pairs, const PairGeometrySpans& geometry) {
  geometry::require_lengths(pairs.pairs.size(), "pairs", pairs.shifts, geometry);
}

}  // namespace

struct PairMeasurer::State {
  template <int Dim>
  struct ReadSets {
    explicit ReadSets(base::MemoryMeter& memory) : first(memory), second(memory) {}
    elements::GatheredElements<Dim> first;
    elements::GatheredElements<Dim> second;
  };

  State(const ElementView& given_first, const ElementView* given_second, const Domain& given_domain,
        const Options& options)
      : domain(given_domain),
        simd(kernels::level_to_run(options.simd)),
        is_one_set(given_second == nullptr),
        dimensions(given_first.dimensions()),
        first_count(given_first.size()),
        second_count(is_one_set ? first_count : given_second->size()) {
    memory.start_anew(detect::memory_bound(options));
    base::DetectionContext context(memory, options.progress);
    workers = base::worker_count(options.threads, first_count + (is_one_set ? 0 : second_count));
    context.progress.begin("gather", first_count + (is_one_set ? 0 : second_count));
    base::letting_through([&] {
      dimensions == 2 ? gather(in_2d, given_first, given_second, context)
                      : gather(in_3d, given_first, given_second, context);
    });
  }

  template <int Dim>
  void gather(ReadSets<Dim>& sets, const ElementView& first, const ElementView* second,
              base::DetectionContext& context) {
    elements::gather<Dim>(first, {workers, simd}, sets.first, context);
    if (second != nullptr) elements::gather<Dim>(*second, {workers, simd}, sets.second, context);
  }

  template <int Dim>
  [[nodiscard]] geometry::MeasuredSets<Dim> measured(const ReadSets<Dim>& sets) const {
    return {sets.first.elements(), is_one_set ? sets.first.elements() : sets.second.elements(),
            elements::lattice_of(domain), kernels::measure_kernels(simd)};
  }

  /// Throws Error{wrong_usage} unless the pairs are pairs of these elements in this domain.
  void require(const PairSpans& pairs) const;

  /// Measures pairs with all workers.
  void measure(const PairSpans& pairs, const PairGeometrySpans& geometry,
               const ProgressHook& progress);

  Domain domain;
  Simd simd;
  bool is_one_set;
  int dimensions;
  std::size_t first_count;
  std::size_t second_count;
  std::size_t workers = 1;
  base::MemoryMeter memory;
  ReadSets<2> in_2d{memory};
  ReadSets<3> in_3d{memory};
};

void PairMeasurer::State::require(const PairSpans& pairs) const {
  geometry::require_shifts(pairs.pairs.size(), "pairs", pairs.shifts, domain);
  std::uint64_t past_first = 0;
  std::uint64_t past_second = 0;
  for (const ContactPair pair : pairs.pairs) {
    past_first = std::max<std::uint64_t>(past_first, std::uint64_t{pair.first} + 1);
    past_second = std::max<std::uint64_t>(past_second, std::uint64_t{pair.second} + 1);
  }
  const auto require_there = [](std::uint64_t past, std::size_t count) {
    if (past <= count) return;
    refuse("a pair names element " + std::to_string(past - 1) + ", but there are " +
           std::to_string(count) + " elements, numbered from 0");
  };
  require_there(past_first, first_count);
  require_there(past_second, second_count);
}

PairMeasurer::PairMeasurer(const ElementView& elements, const Domain& domain,
                           const Options& options) {
  const base::FloatEnvironment environment;
  state_ = base::reporting_lack_of_memory([&] {
    detect::validate(options, elements, domain);
    return std::make_unique<State>(elements, nullptr, domain, options);
  });
}

PairMeasurer::PairMeasurer(const ElementView& first, const ElementView& second,
                           const Domain& domain, const Options& options) {
  const base::FloatEnvironment environment;
  state_ = base::reporting_lack_of_memory([&] {
    detect::validate(options, first, second, domain);
    return std::make_unique<State>(first, &second, domain, options);
  });
}

PairMeasurer::~PairMeasurer() = default;
PairMeasurer::PairMeasurer(PairMeasurer&&) noexcept = default;
PairMeasurer& PairMeasurer::operator=(PairMeasurer&&) noexcept = default;

void PairMeasurer::measure(const PairSpans& pairs, const PairGeometrySpans& geometry) const {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] {
    require_lengths(pairs, geometry);
    state_->require(pairs);
  });
  state_->dimensions == 2 ? geometry::measure_some<2>(state_->measured(state_->in_2d), pairs.pairs,
                                                      pairs.shifts, geometry)
                          : geometry::measure_some<3>(state_->measured(state_->in_3d), pairs.pairs,
                                                      pairs.shifts, geometry);
}

void PairMeasurer::State::measure(const PairSpans& pairs, const PairGeometrySpans& geometry,
                                  const ProgressHook& progress) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory(memory, [&] {
    require_lengths(pairs, geometry);
    require(pairs);
    base::DetectionContext context(memory, progress);
    context.progress.begin("measure", pairs.pairs.size());
    base::letting_through([&] {
      dimensions == 2 ? geometry::measure_pairs<2>(measured(in_2d), pairs.pairs, pairs.shifts,
                                                   geometry, workers, context.work)
                      : geometry::measure_pairs<3>(measured(in_3d), pairs.pairs, pairs.shifts,
                                                   geometry, workers, context.work);
    });
  });
}

void measure(const ElementView& elements, const PairSpans& pairs, const PairGeometrySpans& geometry,
             const Domain& domain, const Options& options) {
  PairMeasurer(elements, domain, options).state_->measure(pairs, geometry, options.progress);
}

void measure(const ElementView& first, const ElementView& second, const PairSpans& pairs,
             const PairGeometrySpans& geometry, const Domain& domain, const Options& options) {
  PairMeasurer(first, second, domain, options).state_->measure(pairs, geometry, options.progress);
}

PairGeometry measure(const ElementView& elements, const PairSpans& pairs, Quantities quantities,
                     const Domain& domain, const Options& options) {
  return base::reporting_lack_of_memory([&] {
    PairGeometry geometry = geometry::arrays_for(pairs.pairs.size(), quantities);
    measure(elements, pairs, geometry.spans(), domain, options);
    return geometry;
  });
}

PairGeometry measure(const ElementView& first, const ElementView& second, const PairSpans& pairs,
                     Quantities quantities, const Domain& domain, const Options& options) {
  return base::reporting_lack_of_memory([&] {
    PairGeometry geometry = geometry::arrays_for(pairs.pairs.size(), quantities);
    measure(first, second, pairs, geometry.spans(), domain, options);
    return geometry;
  });
}

}  // namespace abut
