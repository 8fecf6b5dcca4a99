#include "fuzz/dump_case.hpp"

#include "fuzz/wall_case.hpp"

#include <cstdint>
#include <cstdio>

namespace abut::fuzz {
namespace {

std::string written(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string listed(const auto& values) {
  std::string text;
  for (const auto value : values) text += (text.empty() ? "" : ", ") + std::to_string(value);
  return text;
}

void append_elements(std::string& text, const ElementArrays& elements, const Storage& storage) {
  constexpr const char* axis_names[] = {"x", "y", "z"};
  const auto axes = static_cast<std::size_t>(elements.dimensions);
  const bool boxes = elements.shape == Shape::box;
  text += storage.precision == Precision::float32 ? "# in float" : "# in double";
  text += ", layout " + std::to_string(static_cast<int>(storage.layout)) +
          (storage.common_radius ? ", common radius" : "") + "\n";
  for (std::size_t a = 0; a < axes; ++a)
    text += std::string(axis_names[a]) + (boxes ? "min," : ",");
  for (std::size_t a = 0; boxes && a < axes; ++a) text += std::string(axis_names[a]) + "max,";
  if (!boxes) text += "radius,";
  text.back() = '\n';
  for (std::size_t k = 0; k < elements.size(); ++k) {
    for (std::size_t a = 0; a < axes; ++a) text += written(elements.lower[a][k]) + ",";
    for (std::size_t a = 0; boxes && a < axes; ++a) text += written(elements.upper[a][k]) + ",";
    if (!boxes) text += written(elements.radius[k]) + ",";
    text.back() = '\n';
  }
}

void append_domain(std::string& text, const Domain& domain) {
  if (!domain.is_periodic()) text += "Domain::open()\n";
  for (int k = 0; k < 3; ++k) {
    if (!domain.is_periodic(k)) continue;
    const auto& v = domain.vector(k);
    text += std::string("lattice vector ") + "abc"[k] + " = {" + written(v[0]) + ", " +
            written(v[1]) + ", " + written(v[2]) + "}\n";
  }
}

void append_rule(std::string& text, const Rule& rule) {
  for (const Traits& traits : rule.traits) {
    if (!traits.sets.empty()) text += "sets " + listed(traits.sets) + "\n";
    if (!traits.categories.empty()) text += "categories " + listed(traits.categories) + "\n";
    if (!traits.accepts.empty()) text += "accepts " + listed(traits.accepts) + "\n";
  }
  for (std::uint32_t a = 0; rule.table && a < rule.table->size(); ++a) {
    for (std::uint32_t b = 0; b <= a; ++b) {
      if (rule.table->allows(a, b)) continue;
      text += "deny(" + std::to_string(a) + ", " + std::to_string(b) + ")\n";
    }
  }
  if (!rule.excluded) return;
  text += "excluded";
  for (const ContactPair pair : *rule.excluded) {
    text += " (" + std::to_string(pair.first) + ", " + std::to_string(pair.second) + ")";
  }
  text += "\n";
}

}  // namespace

std::string dump_case(const Case& given) {
  std::string text = "choices " + listed(given.plan.choices) + "; skin of kind " +
                     std::to_string(static_cast<int>(given.plan.skin.kind())) + ", length " +
                     written(given.plan.skin.length()) + "; quantities" +
                     (given.plan.quantities.has(Quantity::distance) ? " distance" : "") +
                     (given.plan.quantities.has(Quantity::vector) ? " vector" : "") + "\n";
  for (std::size_t k = 0; k < given.states.size(); ++k) {
    const System& state = given.states[k];
    text += "\n== state " + std::to_string(k) + ", margin " + written(state.margin) + "\n";
    append_domain(text, state.domain);
    append_rule(text, state.rule);
    append_elements(text, state.first, state.storage[0]);
    if (state.second) {
      text += "# the second set\n";
      append_elements(text, *state.second, state.storage[1]);
    }
  }
  return text;
}

std::string dump_wall_case(const WallCase& given) {
  std::string text =
      "choices " + listed(given.choices) + "; margin " + written(given.margin) + "\n";
  append_domain(text, given.domain);
  text += "# balls\n";
  append_elements(text, given.balls, given.storage[0]);
  text += "# solids\n";
  append_elements(text, given.solids, given.storage[1]);
  text += "# vertices\n";
  for (const auto& [x, y, z] : given.mesh.vertices) {
    text += written(x) + "," + written(y) + "," + written(z) + "\n";
  }
  text += "# triangles\n";
  for (const testing::Cell& cell : given.mesh.triangles) text += listed(cell) + "\n";
  return text;
}

}  // namespace abut::fuzz
