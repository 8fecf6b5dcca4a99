#pragma once

#include <abut/export.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/statistics.hpp>

#include <span>
#include <utility>
#include <vector>

namespace abut {

class Detector;

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
  /// Makes a list with shifts and quantities; called by the library.
  ContactList(std::vector<Contact> contacts, std::vector<ImageShift> shifts, PairGeometry geometry,
              const Statistics& statistics)
      : contacts_(std::move(contacts)),
        shifts_(std::move(shifts)),
        geometry_(std::move(geometry)),
        statistics_(statistics) {}

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

  /// Gaps: distance − radius, <= 0 exactly if the sphere touches the wall.
  ///
  /// In these quantities the sphere is element i and the wall, moved by its shift, element j; each
  /// has one entry for each contact, or none unless Options::quantities asks for it. They err by at
  /// most one unit in the last place, vectors and points by one of their largest component, and
  /// have the same bits on every machine and with every number of threads.
  [[nodiscard]] std::span<const double> gaps() const noexcept { return geometry_.gaps; }

  /// Unit normals from the center of the sphere to the nearest point of the wall; 0 where a center
  /// lies on a mesh. Of a center in a box, its boundary included, the normal of the nearest face
  /// into the box: of several faces the first axis, of two on one axis the lower.
  [[nodiscard]] std::span<const Vector> normals() const noexcept { return geometry_.normals; }

  /// Points of the wall that are nearest to the centers; of a center in a box the nearest point of
  /// the face that gives the normal. They lie beside the sphere, which is not moved.
  [[nodiscard]] std::span<const Vector> points() const noexcept { return geometry_.points; }

  /// Distances of the centers to the wall; of a center in a box minus its depth.
  [[nodiscard]] std::span<const double> distances() const noexcept { return geometry_.distances; }

  /// Vectors from the centers to the points of the wall: distance times normal.
  [[nodiscard]] std::span<const Vector> vectors() const noexcept { return geometry_.vectors; }

  /// Statistics of the search for bounding boxes, with three numbers of their own: `contact_pairs`
  /// counts the contacts, `candidate_tests` the pairs whose distance was computed, and
  /// `exact_decisions` the pairs among these that the filter left undecided.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  friend class Detector;

  std::vector<Contact> contacts_;
  std::vector<ImageShift> shifts_;
  PairGeometry geometry_;
  Statistics statistics_;
};

/// Contacts with walls to measure, with their image shifts in a periodic domain: one for each.
template <class Contact>
struct ContactSpans {
  std::span<const Contact> contacts;        ///< contacts
  std::span<const ImageShift> shifts = {};  ///< image shift of each; none in open space

  /// Takes contacts without shifts, which lie in open space.
  ContactSpans(std::span<const Contact> given) : contacts(given) {}
  /// Takes contacts and their shifts.
  ContactSpans(std::span<const Contact> given, std::span<const ImageShift> given_shifts)
      : contacts(given), shifts(given_shifts) {}
  /// Takes the contacts and shifts of a list.
  ContactSpans(const ContactList<Contact>& list)
      : contacts(list.contacts()), shifts(list.shifts()) {}
};

}  // namespace abut
