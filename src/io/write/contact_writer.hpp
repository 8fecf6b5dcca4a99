#pragma once

#include "io/snapshot.hpp"
#include "io/write/output_file.hpp"
#include "io/write/write_contacts.hpp"

#include <abut/pair.hpp>
#include <abut/pair_geometry.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {

/// What every format of contacts writes from, and the way out.
class ContactWriter {
 public:
  ContactWriter(const ContactOutput& output, const ContactElements& elements,
                std::span<const ContactPair> pairs, const ContactImages& images);
  ContactWriter(const ContactWriter&) = delete;
  ContactWriter& operator=(const ContactWriter&) = delete;

  [[nodiscard]] const ContactElements& elements() const noexcept { return elements_; }
  [[nodiscard]] std::span<const ContactPair> pairs() const noexcept { return pairs_; }
  [[nodiscard]] bool with_ids() const noexcept { return with_ids_; }
  [[nodiscard]] bool is_periodic() const noexcept { return images_.domain.is_periodic(); }
  [[nodiscard]] const Domain& domain() const noexcept { return images_.domain; }
  /// Of pair k; zeros in an open domain.
  [[nodiscard]] ImageShift shift(std::uint64_t k) const {
    return is_periodic() ? images_.shifts[k] : ImageShift{};
  }
  [[nodiscard]] double gap(std::uint64_t k) const noexcept { return gaps_[k]; }

  /// The files' own numbers of the elements of pair k.
  [[nodiscard]] std::int64_t first_id(std::uint64_t k) const {
    return elements_.first.ids[pairs_[k].first];
  }
  [[nodiscard]] std::int64_t second_id(std::uint64_t k) const {
    return elements_.partners().ids[pairs_[k].second];
  }

  /// Names of the columns of a table of the pairs.
  [[nodiscard]] std::vector<std::string_view> column_names() const;

  /// The text written next; `wrote`, `hand_on` and `finish` pass it on to the file.
  [[nodiscard]] std::string& text() noexcept { return text_; }

  /// Hands on what is in `text` if it is much.
  void hand_on();
  void finish();

  /// Tells the progress hook, now and then, how many pairs are written.
  void wrote(std::uint64_t pairs);

  /// The file appears.
  Durability commit() { return file_.commit(); }

 private:
  [[nodiscard]] bool is_cancelled() const;

  const ProgressHook& progress_;
  Progress now_;
  OutputFile file_;
  const ContactElements& elements_;
  ElementView first_;
  ElementView second_;  ///< what j is one of
  std::span<const ContactPair> pairs_;
  const ContactImages& images_;
  NumberArray own_gaps_;  ///< where none were given
  std::span<const double> gaps_;
  bool with_ids_;
  std::string text_;
};

/// One function a format; `write_contacts` chooses.
void write_contacts_csv(ContactWriter& writer);
void write_contacts_json(ContactWriter& writer);
void write_contacts_vtp(ContactWriter& writer);

}  // namespace abut::io
