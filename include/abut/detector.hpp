#pragma once

#include <abut/detect.hpp>
#include <abut/export.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/skin.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace abut {

/// Detects contacts again and again, for example once in each time step, and keeps its memory in
/// between: a call with no more elements and pairs than those before allocates nothing. With a skin
/// it keeps pairs that nearly touch, too, and tests those again while elements move little. The
/// results are those of the free functions of the same names.
///
/// One call at a time; several detectors may work at once.
class ABUT_API Detector {
 public:
  explicit Detector(Options options = {});
  ~Detector();

  Detector(Detector&&) noexcept;
  Detector& operator=(Detector&&) noexcept;

  [[nodiscard]] const Options& options() const noexcept;
  /// For the calls that follow.
  void set_options(Options options);

  /// For the calls that follow; at first there is none. With a skin, pairs come in canonical order
  /// also where they may come as found.
  void set_skin(Skin skin);
  [[nodiscard]] Skin skin() const noexcept;
  /// Names of the elements, one for each, all different, for the calls with one set that follow;
  /// copied. None, as at first: elements are known by their numbers. With a skin, candidate pairs
  /// last while elements come, go, come back and change places in the caller's arrays. Ids never
  /// change a result: set them when they change. Throws Error{invalid_input} where an id comes
  /// twice, and then nothing has changed; a call of another number of elements throws it, too.
  void set_ids(std::span<const std::uint64_t> ids);

  /// Of the calls since the skin was set.
  [[nodiscard]] const SkinStatistics& skin_statistics() const noexcept;

  /// The list is valid until the next call that returns one. Throws as the free function does; the
  /// last list is then empty.
  const PairList& find_contact_pairs(const ElementView& elements,
                                     const Domain& domain = Domain::open());

  Statistics count_contact_pairs(const ElementView& elements,
                                 const Domain& domain = Domain::open());

  Statistics for_each_batch(const ElementView& elements, const Domain& domain,
                            const PairBatchVisitor& visitor);
  Statistics for_each_shifted_batch(const ElementView& elements, const Domain& domain,
                                    const ShiftedBatchVisitor& visitor);

  /// The list is valid until the next call that returns one.
  const NeighborList& build_neighbor_list(const ElementView& elements, const Domain& domain,
                                          NeighborListKind kind);

  /// The same for two sets, as the free functions in two_sets.hpp.
  const PairList& find_contact_pairs(const ElementView& first, const ElementView& second,
                                     const Domain& domain = Domain::open());
  Statistics count_contact_pairs(const ElementView& first, const ElementView& second,
                                 const Domain& domain = Domain::open());
  Statistics for_each_batch(const ElementView& first, const ElementView& second,
                            const Domain& domain, const PairBatchVisitor& visitor);
  Statistics for_each_shifted_batch(const ElementView& first, const ElementView& second,
                                    const Domain& domain, const ShiftedBatchVisitor& visitor);
  const NeighborList& build_neighbor_list(const ElementView& first, const ElementView& second,
                                          const Domain& domain = Domain::open());

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abut
