#pragma once

#include <abut/export.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/statistics.hpp>

#include <span>
#include <utility>
#include <vector>

namespace abut {

/// Contacts that are more than pairs, each once, ascending by the contact and its image shift.
template <class Contact>
class ContactList {
 public:
  /// Makes an empty list.
  ContactList() = default;
  /// Makes a list without shifts; called by the library.
  ContactList(std::vector<Contact> contacts, const Statistics& statistics)
      : contacts_(std::move(contacts)), statistics_(statistics) {}
  /// Makes a list with shifts; called by the library.
  ContactList(std::vector<Contact> contacts, std::vector<ImageShift> shifts,
              const Statistics& statistics)
      : contacts_(std::move(contacts)), shifts_(std::move(shifts)), statistics_(statistics) {}

  /// Number of contacts.
  [[nodiscard]] PairCount size() const noexcept { return contacts_.size(); }
  /// True if there is no contact.
  [[nodiscard]] bool empty() const noexcept { return contacts_.empty(); }
  /// Contact k, from 0; k must be < size().
  [[nodiscard]] const Contact& operator[](PairCount k) const noexcept { return contacts_[k]; }
  /// Iterator to the first contact.
  [[nodiscard]] auto begin() const noexcept { return contacts_.begin(); }
  /// Iterator behind the last contact.
  [[nodiscard]] auto end() const noexcept { return contacts_.end(); }
  /// All contacts.
  [[nodiscard]] std::span<const Contact> contacts() const noexcept { return contacts_; }

  /// Image shift n of the box or mesh, one for each contact. Empty unless Options::shifts asks for
  /// them; zeros in an open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  /// Statistics of the search for bounding boxes, with three numbers of their own: `contact_pairs`
  /// counts the contacts, `candidate_tests` the pairs whose distance was computed, and
  /// `exact_decisions` the pairs among these that the filter left undecided.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  std::vector<Contact> contacts_;
  std::vector<ImageShift> shifts_;
  Statistics statistics_;
};

}  // namespace abut
