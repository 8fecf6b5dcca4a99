#pragma once

#include <abut/box_contacts.hpp>
#include <abut/contact_history.hpp>
#include <abut/contact_list.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/pair.hpp>
#include <abut/triangle_mesh.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace abut {

/// A contact with a mesh that the previous step had and that nothing goes on from.
template <class T>
struct LostMeshContact {
  std::uint64_t sphere = 0;  ///< id of the sphere; without ids its index in that step
  MeshFeature feature;       ///< feature of the mesh
  T value{};                 ///< the caller's value, as it stood in the previous step
};

/// A contact with a box that the previous step had and that no longer exists.
template <class T>
struct LostBoxContact {
  std::uint64_t sphere = 0;  ///< id of the sphere; without ids its index in that step
  ElementIndex box = 0;      ///< index of the box
  T value{};                 ///< the caller's value, as it stood in the previous step
};

namespace detail {

/// Finds contacts with walls of one step among those of the next.
class ABUT_API WallMatcher {
 public:
  /// Stands for no contact of the step before.
  static constexpr PairCount none = std::numeric_limits<PairCount>::max();

  struct Lost {
    PairCount before = 0;
    std::uint64_t sphere = 0;
    MeshFeature feature;  ///< of boxes the interior of that number
  };

  WallMatcher();
  ~WallMatcher();
  WallMatcher(const WallMatcher&) = delete;
  WallMatcher& operator=(const WallMatcher&) = delete;
  WallMatcher(WallMatcher&&) noexcept;
  WallMatcher& operator=(WallMatcher&&) noexcept;

  /// Compares with the contacts accepted last. On an error nothing has changed.
  void match(const ContactSpans<MeshContact>& contacts, const ElementView& spheres,
             const TriangleMesh& mesh, const Domain& domain, std::span<const std::uint64_t> ids);
  void match(const ContactSpans<BoxContact>& contacts, const ElementView& spheres,
             const Domain& domain, std::span<const std::uint64_t> ids);

  /// Keeps the contacts matched last, for the next call to compare with.
  void accept() noexcept;

  /// Of each contact its place in the step before, or none.
  [[nodiscard]] std::span<const PairCount> before() const noexcept;
  [[nodiscard]] std::span<const PairCount> born() const noexcept;
  [[nodiscard]] std::span<const PairCount> passed_on() const noexcept;
  [[nodiscard]] std::span<const Lost> lost() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Makes a record of a contact that is lost.
template <class T>
void record(const WallMatcher::Lost& lost, const T& value, LostMeshContact<T>& to) {
  to = {lost.sphere, lost.feature, value};
}
template <class T>
void record(const WallMatcher::Lost& lost, const T& value, LostBoxContact<T>& to) {
  to = {lost.sphere, lost.feature.number, value};
}

/// What the histories of contacts with meshes and boxes have in common.
template <class T, class LostContact>
requires std::is_trivially_copyable_v<T> && std::is_default_constructible_v<T>
class WallHistory {
 public:
  /// Values of the contacts: one for each of the last list, in its order.
  [[nodiscard]] std::span<T> values() noexcept { return values_; }
  /// Values of the contacts, for reading.
  [[nodiscard]] std::span<const T> values() const noexcept { return values_; }

  /// Number of contacts that the previous step had, too, those passed on included.
  [[nodiscard]] PairCount kept() const noexcept { return kept_; }

  /// Positions in the list of the contacts that are new, ascending.
  [[nodiscard]] std::span<const PairCount> born() const noexcept { return matcher_.born(); }

  /// Contacts of the previous step whose values nobody has now, in its order.
  [[nodiscard]] std::span<const LostContact> lost() const noexcept { return lost_; }

 protected:
  /// Takes over the values of the contacts that the matcher has matched.
  void take_over() {
    try {
      collect();
    } catch (const std::bad_alloc&) {
      ContactMatcher::lack_memory();
    } catch (const std::length_error&) {
      ContactMatcher::lack_memory();
    }
    matcher_.accept();
    values_.swap(next_values_);
    lost_.swap(next_lost_);
    kept_ = values_.size() - matcher_.born().size();
  }

  WallMatcher matcher_;

 private:
  void collect() {
    const std::span<const PairCount> before = matcher_.before();
    next_values_.resize(before.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
      next_values_[k] = before[k] == WallMatcher::none ? T{} : values_[before[k]];
    }
    next_lost_.clear();
    for (const WallMatcher::Lost& lost : matcher_.lost()) {
      record(lost, values_[lost.before], next_lost_.emplace_back());
    }
  }

  std::vector<T> values_;
  std::vector<T> next_values_;
  std::vector<LostContact> lost_;
  std::vector<LostContact> next_lost_;
  PairCount kept_ = 0;
};

}  // namespace detail

/// Values of the caller, one for each contact of spheres and a mesh, taken over from step to step.
/// A contact that persists keeps its value; a new one begins with T{}.
///
/// A contact is a sphere, a feature and an image. It persists
///
/// * while both steps have it, however mesh and spheres move, spheres are renumbered (with ids) or
///   wrapped into the cell;
/// * when the sphere rolls on to the next feature: a contact that is new takes over the value of
///   one that has vanished if both are of the same sphere, their features have a vertex in common,
///   and the directions from the center to the nearest points of the two, as they lie now, are less
///   than 60 degrees apart. Each value goes to one contact: pairs with the nearest directions go
///   first, of several the first by the place in the list, then by that in the previous one.
///
/// So a value is kept across the edges of a floor and around an outer edge, however sharp. It is
/// not handed from a floor to the wall in its corner; nor to a contact that stood beside the one
/// that vanished; nor where a sphere leaps over a triangle in one step.
template <class T>
class MeshContactHistory : public detail::WallHistory<T, LostMeshContact<T>> {
 public:
  /// Brings the history to the contacts of this step: in the order of find_mesh_contacts, all or
  /// some of them, in a periodic domain with their shifts, as found for these spheres and this
  /// mesh. Deterministic; linear in contacts, and in spheres where the domain is periodic or there
  /// are ids.
  ///
  /// Throws Error, and then nothing has changed:
  ///
  /// * `wrong_usage`: contacts in another order, without shifts, or not of these spheres and this
  ///   mesh; a mesh of more or fewer triangles, edges or vertices than the one before (`clear()`
  ///   makes the history forget it; that other triangles are as many is not seen);
  /// * `invalid_input`: ids of another number than spheres; an id that comes twice;
  /// * `limit_exceeded`: memory ran out.
  void update(const ContactSpans<MeshContact>& contacts, const ElementView& spheres,
              const TriangleMesh& mesh, const Domain& domain = Domain::open(),
              std::span<const std::uint64_t> ids = {}) {
    this->matcher_.match(contacts, spheres, mesh, domain, ids);
    this->take_over();
  }

  /// Positions in the list of the contacts that took over the value of another feature, ascending.
  /// A value that lies in the plane of contact must be turned with it.
  [[nodiscard]] std::span<const PairCount> passed_on() const noexcept {
    return this->matcher_.passed_on();
  }

  /// Forgets all contacts, and the mesh.
  void clear() { *this = MeshContactHistory(); }
};

/// Values of the caller, one for each contact of spheres and boxes, taken over from step to step. A
/// contact is a sphere, a box and an image, and persists while both steps have it, whatever part of
/// the box the sphere touches. Boxes are told by their indices, spheres by ids or indices; spheres
/// may be wrapped into the cell.
template <class T>
class BoxContactHistory : public detail::WallHistory<T, LostBoxContact<T>> {
 public:
  /// Brings the history to the contacts of this step: in the order of find_box_contacts, all or
  /// some of them, in a periodic domain with their shifts, as found for these spheres.
  ///
  /// Throws as MeshContactHistory does, and then nothing has changed.
  void update(const ContactSpans<BoxContact>& contacts, const ElementView& spheres,
              const Domain& domain = Domain::open(), std::span<const std::uint64_t> ids = {}) {
    this->matcher_.match(contacts, spheres, domain, ids);
    this->take_over();
  }

  /// Forgets all contacts.
  void clear() { *this = BoxContactHistory(); }
};

}  // namespace abut
