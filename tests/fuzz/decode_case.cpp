#include "fuzz/byte_reader.hpp"
#include "fuzz/domain_maker.hpp"
#include "fuzz/element_maker.hpp"
#include "fuzz/fuzz_case.hpp"
#include "fuzz/number_maker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace abut::fuzz {
namespace {

constexpr std::uint32_t group_count = 4;

/// Mostly few elements: what goes wrong does so with few, and many tests of few see more.
std::size_t element_count(ByteReader& reader) {
  const std::size_t kind = reader.byte();
  if (kind < 208) return kind % 13;
  if (kind < 248) return kind % 41;
  return 25 * (kind - 247);
}

Storage storage_of(ByteReader& reader, Precision precision) {
  const std::size_t kind = reader.below(8);
  return {precision, static_cast<Layout>(kind % 3), kind >= 6};
}

void add_traits(ByteReader& reader, Traits& traits, unsigned kinds) {
  const unsigned bits = reader.byte();
  if ((kinds & 1U) != 0) traits.sets.push_back(bits % group_count);
  if ((kinds & 2U) != 0) traits.categories.push_back(bits >> 2 & 7U);
  if ((kinds & 4U) != 0) traits.accepts.push_back(bits >> 5 | (bits & 1U));
}

void remove_traits(Traits& traits, std::size_t k) {
  const auto take_last = [k](auto& values) {
    if (values.empty()) return;
    values[k] = values.back();
    values.pop_back();
  };
  take_last(traits.sets);
  take_last(traits.categories);
  take_last(traits.accepts);
}

/// Reads the parts of a case in their order.
class Decoder {
 public:
  Decoder(std::span<const std::uint8_t> bytes, std::size_t many)
      : reader_(bytes),
        precision_(reader_.below(4) == 0 ? Precision::float32 : Precision::float64),
        numbers_(reader_, precision_),
        many_(many) {}

  std::optional<Case> read() {
    read_plan();
    const int dimensions = reader_.flag() ? 3 : 2;
    const Shape shape = reader_.below(4) == 0 ? Shape::box : Shape::sphere;
    expanse_ = many_ == 0 ? 1.0 : std::cbrt(static_cast<double>(many_)) / 8.0;
    DomainMaker domain(reader_, numbers_, dimensions, expanse_);
    System state;
    state.margin = reader_.below(3) == 0 ? numbers_.size() : 0.0;
    const std::optional<Domain> made = domain.domain();
    if (!made) return std::nullopt;
    state.domain = *made;
    ElementMaker maker(reader_, numbers_, domain, state.margin);
    read_sets(state, maker, dimensions, shape);
    read_rule(state);
    result_.states.push_back(state);
    for (std::size_t step = reader_.below(4); step > 0; --step) {
      if (!move(state, maker, domain)) break;
      result_.states.push_back(state);
    }
    return result_;
  }

 private:
  void read_plan() {
    for (std::uint8_t& choice : result_.plan.choices) choice = reader_.byte();
    const std::size_t kind = reader_.byte();
    const Quantities distances = kind % 2 != 0 ? Quantity::distance : Quantities();
    const Quantities vectors = kind % 4 >= 2 ? Quantity::vector : Quantities();
    result_.plan.quantities = distances | vectors;
    if (kind < 128) result_.plan.skin = Skin::fixed(numbers_.size() / 16.0);
    if (kind >= 224) result_.plan.skin = Skin::automatic();
  }

  void read_sets(System& state, ElementMaker& maker, int dimensions, Shape shape) {
    const bool two_sets = reader_.below(4) == 0;
    for (std::size_t set = 0; set < (two_sets ? 2 : 1); ++set) {
      state.storage[set] = storage_of(reader_, precision_);
      ElementArrays elements{dimensions, shape, {}, {}, {}};
      const double radius = state.storage[set].common_radius ? numbers_.size() : -1.0;
      for (std::size_t count = count_of_set(); count > 0; --count) {
        maker.add(elements, radius, expanse_);
      }
      (set == 0 ? state.first : state.second.emplace()) = elements;
    }
    for (std::size_t k = 0; k < state.first.size(); ++k) state.ids.push_back(next_id_++);
  }

  std::size_t count_of_set() {
    const std::size_t count = element_count(reader_);
    return many_ == 0 ? count : many_ * (reader_.byte() + 1U) / 256;
  }

  void read_rule(System& state) {
    const std::size_t kind = reader_.byte();
    if (kind < 160) return;
    kinds_ = kind % 8;
    if ((kinds_ & 6U) != 0) kinds_ |= 6U;  // categories and what accepts them go together
    if (kind >= 224) {
      state.rule.table.emplace(group_count);
      kinds_ |= 1U;
      for (std::uint32_t a = 0; a < group_count; ++a) {
        for (std::uint32_t b = 0; b <= a; ++b) {
          if (reader_.below(3) == 0) state.rule.table->deny(a, b);
        }
      }
    }
    for (std::size_t k = 0; k < state.first.size(); ++k) {
      add_traits(reader_, state.rule.traits[0], kinds_);
    }
    for (std::size_t k = 0; state.second && k < state.second->size(); ++k) {
      add_traits(reader_, state.rule.traits[1], kinds_);
    }
    if (kind % 3 == 0) read_exclusions(state);
  }

  void read_exclusions(System& state) {
    auto& excluded = state.rule.excluded.emplace();
    const std::size_t first = state.first.size();
    const std::size_t second = state.second ? state.second->size() : first;
    if (first == 0 || second == 0) return;
    for (std::size_t count = reader_.below(8); count > 0; --count) {
      excluded.push_back({static_cast<ElementIndex>(reader_.byte() % first),
                          static_cast<ElementIndex>(reader_.byte() % second)});
    }
  }

  /// The next state; false where its domain encloses no cell.
  bool move(System& state, ElementMaker& maker, DomainMaker& domain) {
    const std::size_t kind = reader_.byte();
    if ((kind & 1U) != 0) maker.move(state.first);
    if ((kind & 2U) != 0 && state.second) maker.move(*state.second);
    if ((kind & 12U) == 12U) domain.move();
    if ((kind & 48U) == 48U) change_count(state, maker);
    if ((kind & 192U) == 192U) state.margin = numbers_.size();
    const std::optional<Domain> made = domain.domain();
    if (made) state.domain = *made;
    return made.has_value();
  }

  void change_count(System& state, ElementMaker& maker) {
    // Exclusions name elements that were there when they were made.
    const bool may_remove = state.first.size() > 0 && !state.rule.excluded;
    if (may_remove && reader_.flag()) {
      const std::size_t k = reader_.byte() % state.first.size();
      remove_element(state.first, k);
      remove_traits(state.rule.traits[0], k);
      state.ids[k] = state.ids.back();
      state.ids.pop_back();
      return;
    }
    const bool common = state.storage[0].common_radius && state.first.size() > 0 &&
                        state.first.shape == Shape::sphere;
    maker.add(state.first, common ? state.first.radius[0] : -1.0, expanse_);
    add_traits(reader_, state.rule.traits[0], kinds_);
    state.ids.push_back(next_id_++);
  }

  ByteReader reader_;
  Precision precision_;
  NumberMaker numbers_;
  std::size_t many_;
  double expanse_ = 1.0;
  unsigned kinds_ = 0;  ///< of traits that there are
  std::uint64_t next_id_ = 100;
  Case result_;
};

}  // namespace

std::optional<Case> decode_case(std::span<const std::uint8_t> bytes) {
  return Decoder(bytes, 0).read();
}

std::optional<Case> decode_large_case(std::span<const std::uint8_t> bytes,
                                      std::size_t most_elements) {
  return Decoder(bytes, most_elements).read();
}

}  // namespace abut::fuzz
