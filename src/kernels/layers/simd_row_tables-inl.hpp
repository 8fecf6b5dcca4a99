// Tables of the rows of a layer, included once for each instruction set into the namespace of
// layer_search_simd.cpp, whose names it uses: no include guard, and no includes.

/// The entries of a whole vector of records.
HWY_INLINE Numbers entries_of(const PositionRecord* records, const EntryMap& map) {
  const RowMap& rows = map.rows;
  Integers position[3];
  Integers number;
  hn::LoadInterleaved4(integers, records[0].position, position[0], position[1], position[2],
                       number);
  const auto along = [&](int axis) HWY_ATTR {
    return hn::BitCast(numbers, axis == 0 ? position[0] : axis == 1 ? position[1] : position[2]);
  };
  const Numbers row = hn::And(hn::ShiftRightSame(along(rows.next_row_axis), rows.row_shift),
                              hn::Set(numbers, rows.row_mask));
  const Numbers column = hn::ShiftRightSame(along(rows.row_axis), rows.column_shift);
  const Numbers first_of_row = hn::Mul(row, hn::Set(numbers, map.row_length));
  return hn::Add(hn::Add(first_of_row, column), hn::Set(numbers, map.first));
}

void count_entries(const PositionRecord* records, std::size_t count, const EntryMap& map,
                   std::uint32_t* entry_of, std::uint32_t* table) {
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) {
    hn::StoreU(entries_of(records + k, map), numbers, entry_of + k);
    for (std::size_t lane = 0; lane < lanes; ++lane) ++table[entry_of[k + lane]];
  }
  for (; k < count; ++k) ++table[entry_of[k] = map.entry(records[k])];
}

/// Sums of the lanes up to each one. Template for the sake of levels with one lane.
template <class Tag>
HWY_INLINE hn::Vec<Tag> sums_up_to(Tag tag, hn::Vec<Tag> counts) {
  auto sums = hn::Add(counts, hn::ShiftLeftLanes<1>(tag, counts));
  sums = hn::Add(sums, hn::ShiftLeftLanes<2>(tag, sums));
  if constexpr (hn::MaxLanes(Tag()) == 8) {
    const auto of_half = hn::ConcatLowerLower(tag, hn::Broadcast<3>(sums), hn::Zero(tag));
    sums = hn::Add(sums, of_half);
  }
  return sums;
}

/// The last lane in all lanes.
template <class Tag>
HWY_INLINE hn::Vec<Tag> last_of(Tag tag, hn::Vec<Tag> values) {
  const auto of_halves = hn::Broadcast<3>(values);
  if constexpr (hn::MaxLanes(Tag()) == 8) return hn::ConcatUpperUpper(tag, of_halves, of_halves);
  return of_halves;
}

/// Turns a vector of counts into places, in all lanes of `first` the first one. The sums of the
/// next vector do not wait for those of this one.
template <class Tag>
HWY_INLINE void turn_vector(Tag tag, std::uint32_t* counts, hn::Vec<Tag>& first) {
  const auto its = hn::LoadU(tag, counts);
  const auto sums = sums_up_to(tag, its);
  hn::StoreU(hn::Add(first, hn::Sub(sums, its)), tag, counts);
  first = hn::Add(first, last_of(tag, sums));
}

/// Vectors of counts that are looked at together: where nothing is for long, as around clusters,
/// their places are all the same.
constexpr std::size_t vectors_together = 4;

template <class Tag>
HWY_INLINE void turn_vectors(Tag tag, std::uint32_t* counts, hn::Vec<Tag>& first) {
  constexpr std::size_t at_once = hn::MaxLanes(Tag());
  auto some = hn::Zero(tag);
  for (std::size_t v = 0; v < vectors_together; ++v) {
    some = hn::Or(some, hn::LoadU(tag, counts + v * at_once));
  }
  const bool are_zero = hn::AllTrue(tag, hn::Eq(some, hn::Zero(tag)));
  for (std::size_t v = 0; v < vectors_together; ++v, counts += at_once) {
    if (are_zero) {
      hn::StoreU(first, tag, counts);
    } else {
      turn_vector(tag, counts, first);
    }
  }
}

/// Returns how many counts it turned, whole vectors of them.
template <class Tag>
HWY_INLINE std::size_t turn_whole_vectors(Tag tag, std::uint32_t* counts, std::size_t size,
                                          std::uint32_t& place) {
  constexpr std::size_t at_once = hn::MaxLanes(Tag());
  std::size_t k = 0;
  if constexpr (at_once >= 4) {
    auto first = hn::Set(tag, place);
    for (; k + vectors_together * at_once <= size; k += vectors_together * at_once) {
      turn_vectors(tag, counts + k, first);
    }
    for (; k + at_once <= size; k += at_once) turn_vector(tag, counts + k, first);
    place = hn::GetLane(first);
  }
  return k;
}

std::uint32_t turn_into_places(std::uint32_t* counts, std::size_t size, std::uint32_t place) {
  std::size_t k = turn_whole_vectors(numbers, counts, size, place);
  for (; k < size; ++k) place += std::exchange(counts[k], place);
  return place;
}
