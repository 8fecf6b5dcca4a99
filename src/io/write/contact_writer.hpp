#pragma once

#include "io/snapshot.hpp"
#include "io/write/output_file.hpp"
#include "io/write/write_contacts.hpp"

#include <abut/pair.hpp>
#include <abut/pair_geometry.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abut::io {

/// A quantity of all pairs: one number each, or the three of a vector one by one.
struct QuantityColumns {
  std::string_view name;                    ///< "normal"
  std::span<const std::string_view> names;  ///< of its columns: "normal_x", "normal_y", "normal_z"
  const double* first = nullptr;

  [[nodiscard]] std::size_t components() const noexcept { return names.size(); }
  /// The numbers of pair k.
  [[nodiscard]] std::span<const double> of(std::uint64_t k) const noexcept {
    return {first + k * names.size(), names.size()};
  }
};

/// The contacts that every format writes from, and the way out.
class ContactWriter {
 public:
  ContactWriter(const ContactOutput& output, const ContactElements& elements,
                std::span<const ContactPair> pairs, const ContactImages& images,
                const ContactQuantities& quantities);
  ContactWriter(const ContactWriter&) = delete;
  ContactWriter& operator=(const ContactWriter&) = delete;
  ~ContactWriter() = default;

  [[nodiscard]] const ContactElements& elements() const noexcept { return elements_; }
  [[nodiscard]] std::span<const ContactPair> pairs() const noexcept { return pairs_; }
  [[nodiscard]] bool with_ids() const noexcept { return with_ids_; }
  [[nodiscard]] bool is_periodic() const noexcept { return images_.domain.is_periodic(); }
  [[nodiscard]] const Domain& domain() const noexcept { return images_.domain; }
  /// Shift of pair k; zeros in an open domain.
  [[nodiscard]] ImageShift shift(std::uint64_t k) const {
    return is_periodic() ? images_.shifts[k] : ImageShift{};
  }
  /// Gaps first, then the other quantities that are written.
  [[nodiscard]] std::span<const QuantityColumns> quantities() const noexcept { return quantities_; }

  /// The files' own numbers of the elements of pair k.
  [[nodiscard]] std::int64_t first_id(std::uint64_t k) const {
    return elements_.first.ids[pairs_[k].first];
  }
  [[nodiscard]] std::int64_t second_id(std::uint64_t k) const {
    return elements_.partners().ids[pairs_[k].second];
  }

  /// Names of the columns of a table of the pairs.
  [[nodiscard]] std::vector<std::string_view> column_names() const;

  /// The text written next; `wrote`, `write_bytes` and `finish` pass it on to the file.
  [[nodiscard]] std::string& text() noexcept { return text_; }

  /// Writes bytes behind the text.
  void write_bytes(std::span<const std::byte> bytes);
  void finish();

  /// Says how many steps there are for `wrote`; as many as pairs if nothing is said.
  void expect(std::uint64_t steps) noexcept { now_.total = steps; }

  /// Hands on what is in `text` if it is much, and tells the progress hook now and then.
  void wrote(std::uint64_t steps);

  /// The file appears.
  Durability commit() { return file_.commit(); }

 private:
  [[nodiscard]] bool is_cancelled() const;

  const ProgressHook& progress_;
  Progress now_;
  std::uint64_t told_ = 0;  ///< steps
  OutputFile file_;
  const ContactElements& elements_;
  std::span<const ContactPair> pairs_;
  const ContactImages& images_;
  NumberArray own_gaps_;  ///< where none were given
  std::vector<QuantityColumns> quantities_;
  bool with_ids_;
  std::string text_;
};

/// One function a format; `write_contacts` chooses.
void write_contacts_csv(ContactWriter& writer);
void write_contacts_json(ContactWriter& writer);
void write_contacts_vtp(ContactWriter& writer);

}  // namespace abut::io
