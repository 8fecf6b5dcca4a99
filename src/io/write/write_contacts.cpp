#include "io/write/write_contacts.hpp"

#include "io/quoted_text.hpp"
#include "io/suffix.hpp"
#include "io/write/contact_writer.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <optional>

namespace abut::io {
namespace {

std::optional<ContactFormat> format_named(std::string_view name) {
  if (name == "csv") return ContactFormat::csv;
  if (name == "json") return ContactFormat::json;
  if (name == "vtp") return ContactFormat::vtp;
  return std::nullopt;
}

void require_ids(const Snapshot& snapshot) {
  if (snapshot.ids.size() == snapshot.size()) return;
  throw Error(
      ErrorCode::invalid_input,
      fmt::format("{} has no ids of its own; leave out the columns of ids", snapshot.name()));
}

void require_there(const ContactPair& pair, ElementIndex element, const Snapshot& snapshot) {
  if (element < snapshot.size()) return;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("contact pair ({}, {}) names an element beyond the {} there are",
                          pair.first, pair.second, snapshot.size()));
}

void validate(const ContactOutput& output, const ContactElements& elements,
              std::span<const ContactPair> pairs, const ContactImages& images) {
  if (images.domain.is_periodic() && images.shifts.size() != pairs.size()) {
    throw Error(ErrorCode::wrong_usage,
                fmt::format("{} image shifts for {} contact pairs of a periodic domain; find the "
                            "pairs with Shifts::stored",
                            images.shifts.size(), pairs.size()));
  }
  if (output.ids == IdColumns::with) {
    require_ids(elements.first);
    require_ids(elements.partners());
  }
  for (const ContactPair& pair : pairs) {
    require_there(pair, pair.first, elements.first);
    require_there(pair, pair.second, elements.partners());
  }
}

void require_one_each(const ContactQuantities& quantities, std::size_t pairs) {
  for (const std::size_t size :
       {quantities.gaps.size(), quantities.normals.size(), quantities.points.size(),
        quantities.distances.size(), quantities.vectors.size()}) {
    if (size == 0 || size == pairs) continue;
    throw Error(
        ErrorCode::wrong_usage,
        fmt::format("{} numbers of a quantity for {} contact pairs; give one each", size, pairs));
  }
}

}  // namespace

ContactFormat contact_format(std::string_view name, std::string_view path) {
  const std::string suffix = suffix_of(path);
  if (name.empty() && path == "-") return ContactFormat::csv;
  const std::string_view wanted =
      name.empty() ? std::string_view(suffix).substr(suffix.empty() ? 0 : 1) : name;
  if (const std::optional<ContactFormat> format = format_named(wanted)) return *format;
  throw Error(ErrorCode::wrong_usage,
              fmt::format("contacts cannot be written as {}; the formats are csv, json and vtp",
                          quoted(name.empty() ? path : name)));
}

Durability write_contacts(const ContactOutput& output, const ContactElements& elements,
                          std::span<const ContactPair> pairs, const ContactImages& images,
                          const ContactQuantities& quantities) {
  validate(output, elements, pairs, images);
  require_one_each(quantities, pairs.size());
  ContactWriter writer(output, elements, pairs, images, quantities);
  switch (output.format) {
    case ContactFormat::csv:
      write_contacts_csv(writer);
      break;
    case ContactFormat::json:
      write_contacts_json(writer);
      break;
    case ContactFormat::vtp:
      write_contacts_vtp(writer);
      break;
  }
  return writer.commit();
}

}  // namespace abut::io
