#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/options.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/pair_list.hpp>
#include <abut/quantity.hpp>

#include <memory>
#include <span>

namespace abut {

/// Pairs to measure, with their image shifts in a periodic domain: one for each pair.
struct PairSpans {
  std::span<const ContactPair> pairs;       ///< pairs of indices
  std::span<const ImageShift> shifts = {};  ///< image shift of each; none in open space

  /// Takes pairs without shifts, which lie in open space.
  PairSpans(std::span<const ContactPair> given) : pairs(given) {}
  /// Takes pairs and their shifts.
  PairSpans(std::span<const ContactPair> given, std::span<const ImageShift> given_shifts)
      : pairs(given), shifts(given_shifts) {}
  /// Takes the pairs and shifts of a list.
  PairSpans(const PairList& list) : pairs(list.pairs()), shifts(list.shifts()) {}
};

/// Elements that were read once, so that many spans of pairs can be measured, also by several
/// threads at the same time: what a visitor of batches needs.
class ABUT_API PairMeasurer {
 public:
  /// Reads one set of elements. It copies them: what happens to the caller's arrays later does not
  /// matter. Of the options it uses threads, max_bytes, simd and progress. Throws what
  /// find_contact_pairs throws for elements, domain and options.
  explicit PairMeasurer(const ElementView& elements, const Domain& domain = Domain::open(),
                        const Options& options = {});
  /// Reads two sets: pairs name an element of `first` and an element of `second`.
  PairMeasurer(const ElementView& first, const ElementView& second, const Domain& domain,
               const Options& options = {});
  /// Releases the memory.
  ~PairMeasurer();
  /// Takes over another measurer.
  PairMeasurer(PairMeasurer&&) noexcept;
  /// Takes over another measurer.
  PairMeasurer& operator=(PairMeasurer&&) noexcept;
  PairMeasurer(const PairMeasurer&) = delete;
  PairMeasurer& operator=(const PairMeasurer&) = delete;

  /// Measures pairs in the calling thread. Throws Error{wrong_usage} if a pair names an element
  /// that is not there, if an array has another length than the pairs, if a shift is not 0 on an
  /// axis that is not periodic, and if pairs of a periodic domain come without shifts.
  void measure(const PairSpans& pairs, const PairGeometrySpans& geometry) const;

 private:
  struct State;
  friend ABUT_API void measure(const ElementView&, const PairSpans&, const PairGeometrySpans&,
                               const Domain&, const Options&);
  friend ABUT_API void measure(const ElementView&, const ElementView&, const PairSpans&,
                               const PairGeometrySpans&, const Domain&, const Options&);

  std::unique_ptr<State> state_;
};

/// Measures quantities of pairs, with as many threads as the options say. Throws what PairMeasurer
/// throws.
[[nodiscard]] ABUT_API PairGeometry measure(const ElementView& elements, const PairSpans& pairs,
                                            Quantities quantities,
                                            const Domain& domain = Domain::open(),
                                            const Options& options = {});

/// Measures pairs of two sets.
[[nodiscard]] ABUT_API PairGeometry measure(const ElementView& first, const ElementView& second,
                                            const PairSpans& pairs, Quantities quantities,
                                            const Domain& domain = Domain::open(),
                                            const Options& options = {});

/// Measures pairs into the caller's arrays: those that are not empty.
ABUT_API void measure(const ElementView& elements, const PairSpans& pairs,
                      const PairGeometrySpans& geometry, const Domain& domain = Domain::open(),
                      const Options& options = {});

/// Measures pairs of two sets into the caller's arrays.
ABUT_API void measure(const ElementView& first, const ElementView& second, const PairSpans& pairs,
                      const PairGeometrySpans& geometry, const Domain& domain = Domain::open(),
                      const Options& options = {});

}  // namespace abut
