#pragma once

#include "support/exact_oracle.hpp"

#include <abut/domain.hpp>
#include <abut/exclusion_list.hpp>
#include <abut/group_table.hpp>
#include <abut/options.hpp>
#include <abut/skin.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace abut::fuzz {

using testing::ElementArrays;

/// How the caller's arrays lie in memory.
enum class Layout : std::uint8_t { columns, structs, backwards };

struct Storage {
  Precision precision = Precision::float64;
  Layout layout = Layout::columns;
  bool common_radius = false;  ///< all radii are equal, and given as one number
};

/// Owns what PairTraits views.
struct Traits {
  std::vector<std::uint32_t> sets;
  std::vector<std::uint64_t> categories;
  std::vector<std::uint64_t> accepts;

  [[nodiscard]] PairTraits view() const { return {sets, categories, accepts}; }
};

struct Rule {
  std::array<Traits, 2> traits;  ///< of the first and the second set
  std::optional<GroupTable> table;
  std::optional<std::vector<ContactPair>> excluded;
};

/// Elements, or two sets of them, in a domain, and who may pair.
struct System {
  ElementArrays first;
  std::optional<ElementArrays> second;
  std::array<Storage, 2> storage;
  Domain domain = Domain::open();
  double margin = 0.0;
  Rule rule;
  std::vector<std::uint64_t> ids;  ///< of the first set, for a Detector
};

/// What is asked for beside the system; each choice picks one of the ways to ask.
struct Plan {
  std::array<std::uint8_t, 8> choices{};  ///< one for each algorithm
  Quantities quantities;
  Skin skin = Skin::none();
};

/// A system and what becomes of it: the states that a Detector meets one after the other.
struct Case {
  std::vector<System> states;
  Plan plan;
};

/// The case that the bytes describe; none where their domain encloses no cell.
[[nodiscard]] std::optional<Case> decode_case(std::span<const std::uint8_t> bytes);

/// A case of that many elements at the most, for the target of large sizes.
[[nodiscard]] std::optional<Case> decode_large_case(std::span<const std::uint8_t> bytes,
                                                    std::size_t most_elements);

}  // namespace abut::fuzz
