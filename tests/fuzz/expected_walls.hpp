#pragma once

#include "exact/features/geometry_oracle.hpp"
#include "fuzz/wall_case.hpp"

#include <abut/box_contacts.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace abut::fuzz {

struct MovedBoxContact {
  BoxContact contact;
  ImageShift shift;

  friend bool operator==(const MovedBoxContact&, const MovedBoxContact&) = default;
};

/// What the contract says about the contacts with walls, ascending, in rational numbers.
template <class Contact>
struct ExpectedContacts {
  std::vector<Contact> contacts;
  bool may_refuse = false;  ///< something is far out, or reaches far
};

/// None where there are more images within reach than that.
[[nodiscard]] std::optional<ExpectedContacts<MovedBoxContact>> expected_box_contacts(
    const WallCase& given, std::uint64_t most_images);
[[nodiscard]] std::optional<ExpectedContacts<testing::MovedContact>> expected_mesh_contacts(
    const WallCase& given, std::uint64_t most_images);

/// The geometry of one contact.
[[nodiscard]] testing::WallGeometry expected_geometry(const WallCase& given,
                                                      const MovedBoxContact& moved);
[[nodiscard]] testing::WallGeometry expected_geometry(const WallCase& given,
                                                      const TriangleMesh& mesh,
                                                      const testing::MovedContact& moved);

}  // namespace abut::fuzz
