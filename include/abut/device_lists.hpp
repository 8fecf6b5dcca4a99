#pragma once

#include <abut/export.hpp>
#include <abut/image_shift.hpp>
#include <abut/neighbor_list.hpp>
#include <abut/pair.hpp>
#include <abut/pair_list.hpp>
#include <abut/statistics.hpp>

#include <cstddef>

namespace abut::device {

class Backend;

/// The contact pairs of one detection, in canonical order, in the memory of a device. They belong
/// to the detector, and are valid in the order of its stream until its next call.
class ABUT_API PairList {
 public:
  /// Address of the first pair, in the memory of the device.
  [[nodiscard]] const ContactPair* data() const noexcept { return pairs_; }
  /// Address of the first image shift, one for each pair, in the memory of the device. Null unless
  /// Options::shifts asks for them; zeros in an open domain.
  [[nodiscard]] const ImageShift* shifts() const noexcept { return shifts_; }
  /// Address of the first gap, one for each pair as PairGeometry has them, in the memory of the
  /// device. Null unless Options::quantities asks for them.
  [[nodiscard]] const double* gaps() const noexcept { return gaps_; }
  /// Number of pairs.
  [[nodiscard]] PairCount size() const noexcept { return statistics_.contact_pairs; }
  /// True if there is no pair.
  [[nodiscard]] bool empty() const noexcept { return size() == 0; }
  /// Statistics of the detection; peak_bytes are those of the device.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }
  /// Waits until the pairs are there: for programs that measure, or read them in another stream.
  void wait() const;
  /// Copies pairs, shifts and gaps to the host, and waits for them.
  [[nodiscard]] abut::PairList to_host() const;

 private:
  friend class Detector;

  const ContactPair* pairs_ = nullptr;
  const ImageShift* shifts_ = nullptr;
  const double* gaps_ = nullptr;
  Statistics statistics_;
  Backend* backend_ = nullptr;
};

/// The neighbors of each element in compressed rows, as abut::NeighborList has them, in the memory
/// of a device. They belong to the detector, and are valid in the order of its stream until its
/// next call.
class ABUT_API NeighborList {
 public:
  /// Number of rows, one for each element.
  [[nodiscard]] std::size_t size() const noexcept { return rows_; }
  /// Address of the first offset, in the memory of the device: size() + 1 numbers, of which the
  /// first is 0 and the last neighbor_count(). Null if there is no list.
  [[nodiscard]] const PairCount* offsets() const noexcept { return offsets_; }
  /// Address of the first neighbor, in the memory of the device: those of all elements, row after
  /// row.
  [[nodiscard]] const ElementIndex* neighbors() const noexcept { return neighbors_; }
  /// Address of the first image shift, one for each neighbor, in the memory of the device. Null
  /// unless Options::shifts asks for them; zeros in an open domain.
  [[nodiscard]] const ImageShift* shifts() const noexcept { return shifts_; }
  /// Address of the first gap, one for each neighbor, in the memory of the device. Null unless
  /// Options::quantities asks for them.
  [[nodiscard]] const double* gaps() const noexcept { return gaps_; }
  /// Number of neighbors of all elements: in a full list two for each contact pair.
  [[nodiscard]] PairCount neighbor_count() const noexcept { return neighbor_count_; }
  /// Statistics of the detection; peak_bytes are those of the device.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }
  /// Waits until the list is there: for programs that measure, or read it in another stream.
  void wait() const;
  /// Copies the list to the host, and waits for it.
  [[nodiscard]] abut::NeighborList to_host() const;

 private:
  friend class Detector;

  std::size_t rows_ = 0;
  const PairCount* offsets_ = nullptr;
  const ElementIndex* neighbors_ = nullptr;
  const ImageShift* shifts_ = nullptr;
  const double* gaps_ = nullptr;
  PairCount neighbor_count_ = 0;
  Statistics statistics_;
  Backend* backend_ = nullptr;
};

}  // namespace abut::device
