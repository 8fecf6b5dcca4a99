#pragma once

#include <abut/box_contacts.hpp>
#include <abut/detect.hpp>
#include <abut/export.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/skin.hpp>
#include <abut/triangle_mesh.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace abut {

/// Detects contacts again and again, for example once in each time step, and keeps its memory in
/// between: a call with no more elements and pairs than those before allocates nothing. With a skin
/// it keeps pairs that nearly touch, too, and tests those again while elements move little. The
/// results are those of the free functions of the same names.
///
/// A detector takes one call at a time; several detectors may work at once.
class ABUT_API Detector {
 public:
  /// Makes a detector without skin and ids.
  explicit Detector(Options options = {});
  /// Releases the memory.
  ~Detector();

  /// Takes over another detector with its memory and lists.
  Detector(Detector&&) noexcept;
  /// Takes over another detector with its memory and lists.
  Detector& operator=(Detector&&) noexcept;
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  /// Options of the next call.
  [[nodiscard]] const Options& options() const noexcept;
  /// Sets the options for the calls that follow.
  void set_options(Options options);

  /// Sets the skin for the calls that follow; without this call there is none. With a skin, pairs
  /// come in canonical order also where Order::as_found would allow another.
  void set_skin(Skin skin);
  /// Skin of the next call.
  [[nodiscard]] Skin skin() const noexcept;

  /// Sets the ids of the elements, for the calls with one set that follow: one for each element,
  /// all different; they are copied. Without ids (the default, or an empty span) elements are
  /// identified by index. With a skin, ids let candidate pairs last while elements come, go, come
  /// back and change places in the caller's arrays. They never change a result. Call it again
  /// whenever an id changes.
  ///
  /// Throws Error{invalid_input} if an id comes twice, and then nothing has changed. A call with
  /// another number of elements throws it, too.
  void set_ids(std::span<const std::uint64_t> ids);

  /// Statistics of the calls since the skin was set.
  [[nodiscard]] const SkinStatistics& skin_statistics() const noexcept;

  /// Finds all contact pairs. The list is valid until the next call that returns one. Throws what
  /// the free function throws; the last list is then empty.
  const PairList& find_contact_pairs(const ElementView& elements,
                                     const Domain& domain = Domain::open());

  /// Counts the contact pairs without storing them.
  Statistics count_contact_pairs(const ElementView& elements,
                                 const Domain& domain = Domain::open());

  /// Hands the pairs to a visitor in batches.
  Statistics for_each_batch(const ElementView& elements, const Domain& domain,
                            const PairBatchVisitor& visitor);
  /// Hands the pairs and their image shifts to a visitor in batches.
  Statistics for_each_shifted_batch(const ElementView& elements, const Domain& domain,
                                    const ShiftedBatchVisitor& visitor);

  /// Builds a neighbor list, which is valid until the next call that returns one.
  const NeighborList& build_neighbor_list(const ElementView& elements, const Domain& domain,
                                          NeighborListKind kind);

  /// Finds the contact pairs of two sets; see two_sets.hpp.
  const PairList& find_contact_pairs(const ElementView& first, const ElementView& second,
                                     const Domain& domain = Domain::open());
  /// Counts the contact pairs of two sets.
  Statistics count_contact_pairs(const ElementView& first, const ElementView& second,
                                 const Domain& domain = Domain::open());
  /// Hands the pairs of two sets to a visitor in batches.
  Statistics for_each_batch(const ElementView& first, const ElementView& second,
                            const Domain& domain, const PairBatchVisitor& visitor);
  /// Hands the pairs of two sets and their image shifts to a visitor in batches.
  Statistics for_each_shifted_batch(const ElementView& first, const ElementView& second,
                                    const Domain& domain, const ShiftedBatchVisitor& visitor);
  /// Builds a neighbor list with one row for each element of `first` and indices of `second`.
  const NeighborList& build_neighbor_list(const ElementView& first, const ElementView& second,
                                          const Domain& domain = Domain::open());

  /// Finds the contacts of spheres and a mesh: those of the free function. The list is valid until
  /// the next call that returns contacts with a mesh.
  ///
  /// In open space and without a rule, the detector keeps a grid of the triangles from call to
  /// call, also when the mesh is moved (TriangleMesh::move), which costs no new one, and while it
  /// is deformed by little. Elsewhere each call searches anew. One detector is meant for one mesh,
  /// or for several that take turns rarely.
  const MeshContactList& find_mesh_contacts(const ElementView& spheres, const TriangleMesh& mesh,
                                            const Domain& domain = Domain::open());

  /// Finds the contacts of spheres and boxes: those of the free function. Each call searches anew.
  /// The list is valid until the next call that returns contacts with boxes.
  const BoxContactList& find_box_contacts(const ElementView& spheres, const ElementView& boxes,
                                          const Domain& domain = Domain::open());

  /// Takes the last list of pairs out of the detector. Its arrays stay where they are; the next
  /// call that returns pairs allocates anew. It is empty if there is none.
  [[nodiscard]] PairList take_pairs() noexcept;
  /// Takes the last neighbor list out of the detector, as take_pairs does.
  [[nodiscard]] NeighborList take_neighbors() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abut
