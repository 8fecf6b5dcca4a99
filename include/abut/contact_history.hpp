#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/options.hpp>
#include <abut/page_allocator.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace abut {

/// A contact of the previous step that no longer exists, with its last value.
template <class T>
struct LostContact {
  std::uint64_t first = 0;   ///< id of the first element; without ids its index in that step
  std::uint64_t second = 0;  ///< id of the second element
  T value{};                 ///< the caller's value, as it stood in the previous step
};

namespace detail {

/// Finds contact pairs of one step among those of the next.
class ABUT_API ContactMatcher {
 public:
  /// Pairs in a row that both steps have: `count` pairs from `now` on are those from `before` on.
  struct Run {
    PairCount now = 0;
    PairCount before = 0;
    PairCount count = 0;
  };
  struct Lost {
    PairCount before = 0;
    std::uint64_t first = 0;
    std::uint64_t second = 0;
  };
  /// Values of contacts, of so many bytes each, as they are now.
  struct Values {
    std::byte* first = nullptr;
    std::size_t bytes = 0;
    const std::byte* fresh = nullptr;  ///< value of a new contact
    PairCount count = 0;               ///< of contacts
  };

  /// Of the options it uses threads. Throws what the ContactHistory throws.
  explicit ContactMatcher(const Options& options = {});
  ~ContactMatcher();
  ContactMatcher(const ContactMatcher&) = delete;
  ContactMatcher& operator=(const ContactMatcher&) = delete;
  ContactMatcher(ContactMatcher&&) noexcept;
  ContactMatcher& operator=(ContactMatcher&&) noexcept;

  /// Compares with the pairs accepted last. On an error nothing has changed.
  void match(const PairList& pairs, const ElementView& elements, const Domain& domain,
             std::span<const std::uint64_t> ids);

  /// Tells whether the contacts matched last that were there before are in the order of then.
  [[nodiscard]] bool keeps_order() const noexcept;

  /// Moves the values of the contacts accepted last, in the array where they are, to the places of
  /// those matched last; there is room for both. Only where the order is kept. Takes all memory
  /// before a value moves; throws Error{limit_exceeded} if there is none.
  void move_values(const Values& values);

  /// Copies the values of the contacts accepted last to another array, in the order of those
  /// matched last.
  void copy_values(const std::byte* from, const Values& to);

  /// Throws Error{limit_exceeded}, for a lack of memory outside.
  [[noreturn]] static void lack_memory();

  /// Keeps the pairs matched last, for the next call to compare with.
  void accept() noexcept;

  [[nodiscard]] std::span<const PairCount> born() const noexcept;
  [[nodiscard]] std::span<const PairCount> flipped() const noexcept;
  [[nodiscard]] std::span<const Lost> lost() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace detail

/// Values of the caller, one for each contact pair, taken over from step to step. A contact that
/// persists keeps its value; a new one begins with T{}.
///
/// A contact is a pair of elements and an image. It persists also where
///
/// * elements are inserted, removed or renumbered, if each element has an id;
/// * positions are wrapped into the cell, if elements move by less than half a cell in a step.
///
/// Without ids an element is identified by its index.
template <class T>
requires std::is_trivially_copyable_v<T> && std::is_default_constructible_v<T>
class ContactHistory {
 public:
  /// Makes a history without contacts.
  ContactHistory() = default;
  /// Makes a history without contacts. Of the options it uses threads; throws Error{wrong_usage} if
  /// they are negative.
  explicit ContactHistory(const Options& options) : matcher_(options), threads_(options.threads) {}

  /// Brings the history to the contacts of this step: `pairs` in canonical order, in a periodic
  /// domain with their shifts, as found for these elements. Deterministic; linear in pairs and
  /// elements while ids stay or only grow.
  ///
  /// Throws Error, and then nothing has changed:
  ///
  /// * `wrong_usage`: pairs in another order, without shifts, or not of these elements;
  /// * `invalid_input`: ids of another number than elements; an id that comes twice;
  /// * `limit_exceeded`: memory ran out.
  void update(const PairList& pairs, const ElementView& elements,
              const Domain& domain = Domain::open(), std::span<const std::uint64_t> ids = {}) {
    matcher_.match(pairs, elements, domain, ids);
    try {
      collect(pairs.size());
    } catch (const std::bad_alloc&) {
      detail::ContactMatcher::lack_memory();
    } catch (const std::length_error&) {
      detail::ContactMatcher::lack_memory();
    }
    matcher_.accept();
    lost_.swap(next_lost_);
    kept_ = pairs.size() - matcher_.born().size();
  }

  /// Values of the contacts: one for each pair of the last list, in its order.
  [[nodiscard]] std::span<T> values() noexcept { return values_; }
  /// Values of the contacts, for reading.
  [[nodiscard]] std::span<const T> values() const noexcept { return values_; }

  /// Number of contacts that the previous step had, too.
  [[nodiscard]] PairCount kept() const noexcept { return kept_; }

  /// Positions in the list of the contacts that are new, ascending.
  [[nodiscard]] std::span<const PairCount> born() const noexcept { return matcher_.born(); }

  /// Contacts of the previous step that no longer exist.
  [[nodiscard]] std::span<const LostContact<T>> lost() const noexcept { return lost_; }

  /// Positions in the list of kept contacts whose elements have changed roles, ascending: the
  /// element that was `first` is `second` now. Values that point from one element to the other must
  /// be turned around. Empty as long as elements keep their order.
  [[nodiscard]] std::span<const PairCount> flipped() const noexcept { return matcher_.flipped(); }

  /// Forgets all contacts.
  void clear() {
    Options options;
    options.threads = threads_;
    *this = ContactHistory(options);
  }

 private:
  using Values = std::vector<T, detail::PageAllocator<T>>;

  /// Brings the values to their new places, in the array where they are if the contacts keep their
  /// order: all memory is taken, and the value of a new contact made, before the first of them
  /// moves.
  void collect(PairCount count) {
    const T fresh{};
    next_lost_.clear();
    for (const auto& lost : matcher_.lost()) {
      next_lost_.push_back({lost.first, lost.second, values_[lost.before]});
    }
    if (matcher_.keeps_order()) {
      make_room(values_, count);
      matcher_.move_values(bytes_of(values_, count, fresh));
      values_.resize(count);
    } else {
      next_values_.clear();
      make_room(next_values_, count);
      matcher_.copy_values(reinterpret_cast<const std::byte*>(values_.data()),
                           bytes_of(next_values_, count, fresh));
      values_.swap(next_values_);
    }
  }

  static detail::ContactMatcher::Values bytes_of(Values& values, PairCount count, const T& fresh) {
    return {reinterpret_cast<std::byte*>(values.data()), sizeof(T),
            reinterpret_cast<const std::byte*>(&fresh), count};
  }

  static void make_room(Values& values, PairCount count) {
    if (values.capacity() < count) reserve_to_grow(values, count);
    values.resize(std::max<PairCount>(values.size(), count));
  }

  /// Where contacts become more from step to step, an eighth more than is needed, if it can be had:
  /// to write into fresh memory in each step takes longer than all the rest.
  static void reserve_to_grow(Values& values, PairCount count) {
    if (values.capacity() != 0) {
      try {
        return values.reserve(count + count / 8);
      } catch (const std::bad_alloc&) {
      }
    }
    values.reserve(count);
  }

  detail::ContactMatcher matcher_;
  Values values_;
  Values next_values_;  ///< used where contacts have changed their order
  std::vector<LostContact<T>> lost_;
  std::vector<LostContact<T>> next_lost_;
  PairCount kept_ = 0;
  int threads_ = 0;
};

}  // namespace abut
