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
  ContactList() = default;
  ContactList(std::vector<Contact> contacts, const Statistics& statistics)
      : contacts_(std::move(contacts)), statistics_(statistics) {}
  ContactList(std::vector<Contact> contacts, std::vector<ImageShift> shifts,
              const Statistics& statistics)
      : contacts_(std::move(contacts)), shifts_(std::move(shifts)), statistics_(statistics) {}

  [[nodiscard]] PairCount size() const noexcept { return contacts_.size(); }
  [[nodiscard]] bool empty() const noexcept { return contacts_.empty(); }
  [[nodiscard]] const Contact& operator[](PairCount k) const noexcept { return contacts_[k]; }
  [[nodiscard]] auto begin() const noexcept { return contacts_.begin(); }
  [[nodiscard]] auto end() const noexcept { return contacts_.end(); }
  [[nodiscard]] std::span<const Contact> contacts() const noexcept { return contacts_; }

  /// Of each contact the shift n of the box or mesh that is touched. Empty unless Options::shifts
  /// asks for them; zeros in an open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  /// Of the search of bounding boxes, but for these: `contact_pairs` counts the contacts,
  /// `candidate_tests` the pairs whose distance was looked at, `exact_decisions` those of them that
  /// the filter left undecided.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  std::vector<Contact> contacts_;
  std::vector<ImageShift> shifts_;
  Statistics statistics_;
};

}  // namespace abut
