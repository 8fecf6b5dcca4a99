#pragma once

#include <abut/export.hpp>
#include <abut/pair.hpp>
#include <abut/statistics.hpp>

#include <span>
#include <utility>
#include <vector>

namespace abut {

/// Contacts that are more than pairs, each once, in ascending order.
template <class Contact>
class ContactList {
 public:
  ContactList() = default;
  ContactList(std::vector<Contact> contacts, const Statistics& statistics)
      : contacts_(std::move(contacts)), statistics_(statistics) {}

  [[nodiscard]] PairCount size() const noexcept { return contacts_.size(); }
  [[nodiscard]] bool empty() const noexcept { return contacts_.empty(); }
  [[nodiscard]] const Contact& operator[](PairCount k) const noexcept { return contacts_[k]; }
  [[nodiscard]] auto begin() const noexcept { return contacts_.begin(); }
  [[nodiscard]] auto end() const noexcept { return contacts_.end(); }
  [[nodiscard]] std::span<const Contact> contacts() const noexcept { return contacts_; }

  /// Of the search of bounding boxes, but for these: `contact_pairs` counts the contacts,
  /// `candidate_tests` the pairs whose distance was looked at, `exact_decisions` those of them that
  /// the filter left undecided.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  std::vector<Contact> contacts_;
  Statistics statistics_;
};

}  // namespace abut
