#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "detect/validate_options.hpp"
#include "elements/element_ids.hpp"
#include "geometry/spans.hpp"
#include "history/cell_jumps.hpp"
#include "history/handover.hpp"
#include "history/wall_key.hpp"
#include "walls/require_walls.hpp"

#include <abut/error.hpp>
#include <abut/wall_history.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abut::detail {
namespace {

using history::WallKey;

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorCode::wrong_usage, what);
}

/// Numbers of faces, edges and vertices, in this order.
using Extent = std::array<std::size_t, 3>;

Extent extent_of(const TriangleMesh& mesh) {
  return {mesh.size(), mesh.edges().size(), mesh.vertices().size()};
}

/// Throws unless the mesh has the feature.
void require_there(const Extent& extent, const MeshFeature& feature) {
  const auto kind = static_cast<std::size_t>(feature.kind) - 1;
  if (kind < extent.size() && feature.number < extent[kind]) return;
  refuse("a contact names feature " + std::to_string(feature.number) +
         ", which the mesh does not have; give the mesh that the contacts were found for");
}

walls::MovedFeature wall_of(const MeshContact& contact) {
  return {contact.feature, {}};
}
walls::MovedFeature wall_of(const BoxContact& contact) {
  return {{FeatureKind::interior, contact.box}, {}};
}

/// A contact of the step before, as it would be called now.
struct Carried {
  WallKey key;
  PairCount origin;
};

}  // namespace

struct WallMatcher::State {
  // State of the step that was accepted last.
  std::vector<WallKey> keys;
  Extent extent{};
  elements::ElementIds ids;
  history::CellJumps jumps;

  // State of the step that was matched last.
  std::vector<WallKey> next_keys;
  Extent next_extent{};
  elements::ElementIds next_ids;
  bool ids_change = false;
  std::vector<std::uint32_t> number_before;
  std::vector<std::uint32_t> number_now;
  std::vector<Carried> carried;
  std::vector<PairCount> before;
  std::vector<Lost> lost;
  std::vector<WallKey> born_keys;
  std::vector<WallKey> gone_keys;
  std::vector<PairCount> gone;  ///< places in the step before; `none` where a contact goes on
  history::Handover handover;

  // These are read after accept(): those of a match that fails stay aside.
  std::vector<PairCount> born;
  std::vector<PairCount> passed_on;
  std::vector<PairCount> next_born;
  std::vector<PairCount> next_passed_on;

  template <class Contact>
  [[gnu::visibility("hidden")]] void read(const ContactSpans<Contact>& contacts,
                                          const ElementView& spheres, const Domain& domain);
  void carry(const ElementView& spheres, const Domain& domain,
             std::span<const std::uint64_t> given);
  void merge();
  void pass_on(const ElementView& spheres, const TriangleMesh& mesh, const Domain& domain);
  void lose();
  template <class Contact, class Act>
  void match(const ContactSpans<Contact>& contacts, const ElementView& spheres,
             const Domain& domain, std::span<const std::uint64_t> given, Act&& act);
};

template <class Contact>
void WallMatcher::State::read(const ContactSpans<Contact>& contacts, const ElementView& spheres,
                              const Domain& domain) {
  const std::size_t count = contacts.contacts.size();
  geometry::require_lengths(count, "contacts", contacts.shifts, {});
  geometry::require_shifts(count, "contacts", contacts.shifts, domain);
  next_keys.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Contact& contact = contacts.contacts[k];
    WallKey& key = next_keys[k];
    key = {contact.sphere, wall_of(contact)};
    if (!contacts.shifts.empty()) key.wall.shift = contacts.shifts[k];
    if (contact.sphere >= spheres.size()) {
      refuse("contact " + std::to_string(k) + " is of sphere " + std::to_string(contact.sphere) +
             ", but there are " + std::to_string(spheres.size()) +
             "; give the spheres that the contacts were found for");
    }
    if (k > 0 && !(next_keys[k - 1] < key)) {
      refuse("contact " + std::to_string(k) +
             " does not come after the one before it; keep contacts in the order in which they are "
             "found, and in a periodic domain ask for Shifts::stored");
    }
  }
}

/// The contacts of the step before, called as they are called now and ascending by that. Those of
/// spheres that are no more are gone.
void WallMatcher::State::carry(const ElementView& spheres, const Domain& domain,
                               std::span<const std::uint64_t> given) {
  number_before.clear();
  ids_change = !ids.same(given, spheres.size());
  if (ids_change) {
    next_ids.set(given, spheres.size());
    next_ids.find_in(ids, number_before);
    ids.find_in(next_ids, number_now);
  }
  jumps.find(spheres, domain, number_before, 1);
  carried.clear();
  for (std::size_t k = 0; k < keys.size(); ++k) {
    WallKey key = keys[k];
    if (ids_change) key.sphere = number_now[key.sphere];
    if (key.sphere == elements::ElementIds::none) {
      gone_keys.push_back(key);
      gone.push_back(k);
      continue;
    }
    if (jumps.any()) key.wall.shift = history::sum_of(key.wall.shift, jumps.of(key.sphere));
    carried.push_back({key, k});
  }
  const auto ascend = [](const Carried& a, const Carried& b) { return a.key < b.key; };
  if (!std::is_sorted(carried.begin(), carried.end(), ascend)) {
    std::sort(carried.begin(), carried.end(), ascend);
  }
}

void WallMatcher::State::merge() {
  before.assign(next_keys.size(), none);
  auto old = carried.begin();
  const auto go = [&] {
    gone_keys.push_back(old->key);
    gone.push_back(old->origin);
    ++old;
  };
  for (std::size_t k = 0; k < next_keys.size(); ++k) {
    while (old != carried.end() && old->key < next_keys[k]) go();
    if (old != carried.end() && old->key == next_keys[k]) {
      before[k] = old->origin;
      ++old;
    } else {
      next_born.push_back(k);
      born_keys.push_back(next_keys[k]);
    }
  }
  while (old != carried.end()) go();
}

/// Contacts with a mesh go on where a sphere has rolled on to the next feature.
void WallMatcher::State::pass_on(const ElementView& spheres, const TriangleMesh& mesh,
                                 const Domain& domain) {
  for (const auto& [at, from] : handover.find(born_keys, gone_keys, spheres, mesh, domain)) {
    next_passed_on.push_back(next_born[at]);
    before[next_born[at]] = gone[from];
    gone[from] = none;
  }
  std::sort(next_passed_on.begin(), next_passed_on.end());
  std::erase_if(next_born, [&](PairCount k) { return before[k] != none; });
}

void WallMatcher::State::lose() {
  for (const PairCount k : gone) {
    if (k == none) continue;
    lost.push_back({k, ids.of(keys[k].sphere), keys[k].wall.feature});
  }
  std::sort(lost.begin(), lost.end(),
            [](const Lost& a, const Lost& b) { return a.before < b.before; });
}

template <class Contact, class Act>
void WallMatcher::State::match(const ContactSpans<Contact>& contacts, const ElementView& spheres,
                               const Domain& domain, std::span<const std::uint64_t> given,
                               Act&& act) {
  detect::require_dimensions(spheres, domain);
  lost.clear();
  gone.clear();
  gone_keys.clear();
  born_keys.clear();
  next_born.clear();
  next_passed_on.clear();
  read(contacts, spheres, domain);
  carry(spheres, domain, given);
  merge();
  act();
  lose();
}

WallMatcher::WallMatcher()
    : state_(base::reporting_lack_of_memory([] { return std::make_unique<State>(); })) {}
WallMatcher::~WallMatcher() = default;
WallMatcher::WallMatcher(WallMatcher&&) noexcept = default;
WallMatcher& WallMatcher::operator=(WallMatcher&&) noexcept = default;

void WallMatcher::match(const ContactSpans<MeshContact>& contacts, const ElementView& spheres,
                        const TriangleMesh& mesh, const Domain& domain,
                        std::span<const std::uint64_t> ids) {
  const base::FloatEnvironment environment;
  State& state = *state_;
  base::reporting_lack_of_memory([&] {
    walls::require_spheres(spheres);
    walls::require_its_domain(mesh, domain);
    const Extent extent = extent_of(mesh);
    for (const MeshContact& contact : contacts.contacts) require_there(extent, contact.feature);
    if (state.extent != Extent{} && state.extent != extent) {
      refuse(
          "the mesh has other triangles than that of the step before; one history is for one mesh, "
          "clear() makes it forget the mesh");
    }
    state.match(contacts, spheres, domain, ids, [&] { state.pass_on(spheres, mesh, domain); });
    state.next_extent = extent;
  });
}

void WallMatcher::match(const ContactSpans<BoxContact>& contacts, const ElementView& spheres,
                        const Domain& domain, std::span<const std::uint64_t> ids) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] { state_->match(contacts, spheres, domain, ids, [] {}); });
}

void WallMatcher::accept() noexcept {
  State& state = *state_;
  state.keys.swap(state.next_keys);
  state.extent = state.next_extent;
  if (state.ids_change) std::swap(state.ids, state.next_ids);
  state.jumps.accept();
  state.born.swap(state.next_born);
  state.passed_on.swap(state.next_passed_on);
}

std::span<const PairCount> WallMatcher::before() const noexcept {
  return state_->before;
}
std::span<const PairCount> WallMatcher::born() const noexcept {
  return state_->born;
}
std::span<const PairCount> WallMatcher::passed_on() const noexcept {
  return state_->passed_on;
}
std::span<const WallMatcher::Lost> WallMatcher::lost() const noexcept {
  return state_->lost;
}

}  // namespace abut::detail
