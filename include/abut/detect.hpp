#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/options.hpp>
#include <abut/pair_list.hpp>

#include <concepts>
#include <cstddef>
#include <functional>
#include <span>

namespace abut {

/// Finds all contact pairs: i < j with |x_i - x_j| <= r_i + r_j + margin, decided as in real
/// arithmetic on the given numbers; each pair once. In a periodic domain every image of j within
/// reach of i is a pair, and of the images of i itself one of each two opposite ones.
/// docs/contract.md states it in full.
///
/// Throws Error:
///
/// * `invalid_input`: a NaN, an infinity or a negative radius (the message names the first bad
///   element and its field); elements so far out that an image shift would exceed 32 bits;
/// * `wrong_usage`: an option out of range, an algorithm that does not support what was asked, a
///   domain of other dimensions than the elements;
/// * `limit_exceeded`: more pairs than max_pairs, or more memory than the bound, with the bytes
///   needed;
/// * `cancelled`: the progress hook asked to stop.
///
/// On any error nothing is returned and nothing has changed.
[[nodiscard]] ABUT_API PairList find_contact_pairs(const ElementView& elements,
                                                   const Domain& domain = Domain::open(),
                                                   const Options& options = {});

/// Counts the contact pairs without storing them: `contact_pairs` of what it returns.
[[nodiscard]] ABUT_API Statistics count_contact_pairs(const ElementView& elements,
                                                      const Domain& domain = Domain::open(),
                                                      const Options& options = {});

/// Number of the worker that found a pair, from 0 to Statistics::threads − 1.
using WorkerNumber = int;

/// Function that receives pairs in batches, in as_found order.
using PairBatchVisitor = std::function<void(std::span<const ContactPair>, WorkerNumber)>;

/// Function that receives pairs in batches with the image shift of each, zeros in an open domain.
using ShiftedBatchVisitor =
    std::function<void(std::span<const ContactPair>, std::span<const ImageShift>, WorkerNumber)>;

/// Hands the pairs to a visitor in batches as they are found, without storing them. With more than
/// one thread the visitor is called from all of them at the same time.
ABUT_API Statistics for_each_batch(const ElementView& elements, const Domain& domain,
                                   const Options& options, const PairBatchVisitor& visitor);
/// Hands the pairs and their image shifts to a visitor in batches, as for_each_batch does.
ABUT_API Statistics for_each_shifted_batch(const ElementView& elements, const Domain& domain,
                                           const Options& options,
                                           const ShiftedBatchVisitor& visitor);

namespace detail {

template <class Visitor>
concept PairVisitor =
    std::invocable<Visitor&, ContactPair> || std::invocable<Visitor&, ContactPair, WorkerNumber>;

template <class Visitor>
concept ShiftedPairVisitor = std::invocable<Visitor&, ContactPair, ImageShift> ||
    std::invocable<Visitor&, ContactPair, ImageShift, WorkerNumber>;

/// Hands the pairs of a batch to `visitor`, one after the other.
template <class Visitor>
auto pair_by_pair(Visitor& visitor) {
  return [&visitor](std::span<const ContactPair> pairs, WorkerNumber worker) {
    for (const ContactPair& pair : pairs) {
      if constexpr (std::invocable<Visitor&, ContactPair, WorkerNumber>) {
        visitor(pair, worker);
      } else {
        static_cast<void>(worker);
        visitor(pair);
      }
    }
  };
}

template <class Visitor>
auto shifted_pair_by_pair(Visitor& visitor) {
  return [&visitor](std::span<const ContactPair> pairs, std::span<const ImageShift> shifts,
                    WorkerNumber worker) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if constexpr (std::invocable<Visitor&, ContactPair, ImageShift, WorkerNumber>) {
        visitor(pairs[k], shifts[k], worker);
      } else {
        static_cast<void>(worker);
        visitor(pairs[k], shifts[k]);
      }
    }
  };
}

}  // namespace detail

/// Calls `visitor(pair)` or `visitor(pair, worker)` once for each contact pair, in as_found order.
/// An exception from the visitor stops the detection and passes through.
template <detail::PairVisitor Visitor>
Statistics for_each_contact_pair(const ElementView& elements, const Domain& domain,
                                 const Options& options, Visitor&& visitor) {
  return for_each_batch(elements, domain, options, detail::pair_by_pair(visitor));
}

/// Calls `visitor(pair, shift)` or `visitor(pair, shift, worker)` once for each contact pair, as
/// for_each_contact_pair does.
template <detail::ShiftedPairVisitor Visitor>
Statistics for_each_shifted_pair(const ElementView& elements, const Domain& domain,
                                 const Options& options, Visitor&& visitor) {
  return for_each_shifted_batch(elements, domain, options, detail::shifted_pair_by_pair(visitor));
}

/// Computes the gap of a pair: distance − (r_i + r_j), whatever the margin; for boxes the largest
/// separation over the axes. It is <= 0 exactly if the two elements touch, and has the same bits
/// everywhere. Both indices must be < size().
[[nodiscard]] ABUT_API double gap(const ElementView& elements, ContactPair pair);

/// Computes the gap of `pair.first` and `pair.second` moved by `shift`, which must be 0 on axes
/// that are not periodic.
[[nodiscard]] ABUT_API double gap(const ElementView& elements, const Domain& domain,
                                  ContactPair pair, const ImageShift& shift);

}  // namespace abut
