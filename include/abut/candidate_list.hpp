#pragma once

#include <abut/detect.hpp>
#include <abut/export.hpp>
#include <abut/neighbor_list.hpp>

#include <cstdint>
#include <memory>

namespace abut {

/// Candidate pairs for loops that test distances themselves: rows of all pairs that lie within the
/// reach and a skin when the list is made. The list holds every contact pair, and more, until
/// `needs_rebuild` says otherwise; then it is made anew. A Detector with a skin, in contrast,
/// returns the contact pairs alone.
///
/// Between two calls of `rebuild` positions may change, but nothing else: neither radii, number,
/// order and rule of the elements, nor the domain. In a periodic domain elements may leave the
/// cell; those that are brought back into it count as moved by a lattice vector, so do it just
/// before `rebuild`.
class ABUT_API CandidateList {
 public:
  /// Makes a list without rows. `skin`, in the unit of the positions, is added to
  /// `options.margin`. Throws Error{invalid_input} unless it is finite and not negative.
  explicit CandidateList(double skin, NeighborListKind kind = NeighborListKind::half,
                         Options options = {});
  /// Releases the memory.
  ~CandidateList();
  /// Takes over another list with its memory.
  CandidateList(CandidateList&&) noexcept;
  /// Takes over another list with its memory.
  CandidateList& operator=(CandidateList&&) noexcept;
  CandidateList(const CandidateList&) = delete;
  CandidateList& operator=(const CandidateList&) = delete;

  /// Makes the rows of these elements and remembers where they are. Allocates nothing if there are
  /// no more elements and pairs than before. Throws what build_neighbor_list throws, and
  /// Error{wrong_usage} for boxes; there are no rows then.
  const NeighborList& rebuild(const ElementView& elements, const Domain& domain = Domain::open());

  /// Tells whether the rows may lack a contact pair of the elements where they are now: true if two
  /// elements may have come closer by more than the skin, if that is 0, if the number of elements
  /// differs, and if there are no rows. Reads the positions alone; a coordinate that is no number
  /// makes it true.
  [[nodiscard]] bool needs_rebuild(const ElementView& elements) const;

  /// Rows that were made last; quantities and statistics are of that time.
  [[nodiscard]] const NeighborList& rows() const noexcept;

  /// Skin as given.
  [[nodiscard]] double skin() const noexcept;

  /// Number of times that rows were made.
  [[nodiscard]] std::uint64_t rebuilds() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abut
