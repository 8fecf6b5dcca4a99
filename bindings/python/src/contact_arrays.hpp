#pragma once

#include "number_buffer.hpp"

#include <abut/contact_list.hpp>
#include <abut/image_shift.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace abut::python {

/// Contacts with walls in a table of bytes, a row for each, and their shifts in one of int32 with
/// three columns. The package makes them so.
template <class Contact>
class ContactArrays {
 public:
  /// Holds the tables; `shifts` may be None.
  ContactArrays(nb::handle records, nb::handle shifts) : record_buffer_(records) {
    if (!is_table(record_buffer_, sizeof(Contact), 1)) {
      throw nb::type_error("a table with the bytes of each contact is needed");
    }
    if (shifts.is_none()) return;
    shift_buffer_.emplace(shifts);
    if (!is_table(*shift_buffer_, 3, sizeof(std::int32_t)) ||
        shift_buffer_->size(0) != record_buffer_.size(0)) {
      throw nb::type_error("a table with a shift for each contact is needed");
    }
  }

  [[nodiscard]] ContactSpans<Contact> spans() const noexcept {
    const std::span contacts(reinterpret_cast<const Contact*>(record_buffer_.first()),
                             record_buffer_.size(0));
    if (!shift_buffer_) return contacts;
    return {contacts, std::span(reinterpret_cast<const ImageShift*>(shift_buffer_->first()),
                                shift_buffer_->size(0))};
  }

 private:
  static bool is_table(const NumberBuffer& buffer, std::size_t columns, std::size_t bytes) {
    const auto address = reinterpret_cast<std::uintptr_t>(buffer.first());
    return buffer.axes() == 2 && buffer.size(1) == columns && buffer.number_bytes() == bytes &&
           buffer.is_contiguous() && address % alignof(Contact) == 0;
  }

  NumberBuffer record_buffer_;
  std::optional<NumberBuffer> shift_buffer_;
};

}  // namespace abut::python
