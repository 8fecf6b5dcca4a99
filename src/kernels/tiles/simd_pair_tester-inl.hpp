// Elements and their candidates in vectors, included once for each instruction set into the
// namespace of tile_search_simd.cpp, whose names it uses: no include guard, and no includes.

/// Tests an element against runs of candidates.
template <int Dim, ElementShape Shape>
class SimdPairTester {
 public:
  HWY_INLINE SimdPairTester(const TileView& tile, SearchJob& job)
      : tile_(tile),
        job_(job),
        hits_(*job.hits),
        sorted_{{tile.center[0], tile.center[1], tile.center[2]},
                {tile.size[0], tile.size[1], tile.size[2]},
                tile.number},
        block_(job),
        element_(job.hits->element),
        partner_(job.hits->partner) {}

  HWY_INLINE void finish() { job_.candidate_tests += std::exchange(candidate_tests_, 0); }

  HWY_INLINE void take_now_and_then() {
    if (HWY_UNLIKELY(candidate_tests_ >= tests_between_takes)) take();
  }

  /// Elements [first, last), each with the runs that `runs_of` gives for it.
  template <class RunsOf>
  HWY_INLINE void test_all(std::uint32_t first, std::uint32_t last, RunsOf runs_of) {
    for (; first < last; first += batch_size) {
      test_batch(first, std::min(last, first + batch_size), runs_of);
      take_now_and_then();
    }
  }

  /// Elements [first, last) of a row, each with those of the cells that it lies near: run by run,
  /// of a batch of elements at a time.
  template <std::size_t Runs>
  HWY_INLINE void test_nearby(std::uint32_t first, std::uint32_t last,
                              const RowOfCells<Runs>& row) {
    if constexpr (Shape != ElementShape::boxes) {
      SimdNearby<Dim, Shape, Runs> nearby(tile_, job_);
      Probe probe = probe_of(first);
      const Columns columns = sorted_;
      const std::uint32_t* const cell = tile_.cell;
      for (; first < last; first += nearby.batch_size) {
        const std::uint32_t end = std::min(last, first + nearby.batch_size);
        nearby.list(first, end, row);
        const std::uint32_t* const before = nearby.before();
        const std::uint32_t* const after = nearby.after();
        std::size_t tests = 0;
        const auto test = [&](std::uint32_t p, Run run) {
          probe.move_to(columns, tile_, job_, p);
          const Filtered filtered = probe.filter(columns, run.begin);
          const std::uint32_t size = run.end - run.begin;
          if (HWY_UNLIKELY(size > lanes || bits_of(filtered.hit) != 0)) return test_run(p, run);
          tests += size;
        };
        const std::uint32_t* const begin = tile_.cell_begin;
        for (std::uint32_t p = first; p < end; ++p)
          test(p, {p + 1, begin[cell[p] + 1 + after[p - first]]});
        for (std::size_t k = 1; k < Runs; ++k) {
          const std::uint32_t* const ahead = begin + row.step[k];
          for (const std::uint32_t p : nearby.near_run(k)) {
            test(p, {ahead[cell[p] - before[p - first]], ahead[cell[p] + 1 + after[p - first]]});
          }
        }
        candidate_tests_ += tests;
      }
    }
  }

  /// The first `own` elements of the runs, each with all that follow it.
  HWY_INLINE void test_block(std::uint32_t own, std::span<const Run> runs) {
    const bool are_few = expects_few_hits_ && !expects_undecided_count_;
    const std::size_t size = are_few ? block_.gather(wide_floats, sorted_, runs, job_)
                                     : block_.gather(floats, sorted_, runs, job_);
    if (are_few && Block::most_vectors(size) <= VectorList::most) {
      return test_block_with_few_hits(own, runs[0].begin, size);
    }
    std::size_t hits = 0;
    const bool takes_long = own * size > tests_between_takes;
    for (std::uint32_t k = 0; k < own && k + 1 < size; ++k) {
      const std::size_t first = k + 1;
      if (HWY_UNLIKELY(takes_long)) take_now_and_then();
      candidate_tests_ += size - first;
      make_room(size + lanes);
      const std::size_t found = hits_.found;
      const bool quickly = size + lanes <= HitBuffer::size && !expects_undecided_count_;
      if (HWY_LIKELY(quickly) && test_gathered(runs[0].begin + k, first, size)) {
        hits += hits_.found - found;
        continue;
      }
      const std::size_t undecided_count = hits_.undecided_count;
      test_with_care(probe_of(runs[0].begin + k), block_.columns(), first, size);
      expects_undecided_count_ = hits_.undecided_count != undecided_count;
    }
    expects_few_hits_ = hits_are_few(hits, own, size);
  }

  void test(const CoarseElement& coarse, std::span<const Run> runs) {
    const Probe probe(tile_, job_, coarse);
    if (test_runs(probe, RunList{runs})) return;
    for (const Run& run : runs) test_with_care(probe, run);
  }

 private:
  using Probe = SimdProbe<Dim, Shape>;
  using Block = SimdBlock<Dim, Shape>;
  using VectorList = typename Block::VectorList;
  using Row = SimdRow<Probe>;

  /// The hits of an element among the first eight candidates of each run: a byte for each run.
  using Hits = std::uint64_t;
  /// Runs are longer.
  static constexpr Hits unknown = ~Hits{0};
  /// The filter could not decide everything. Less than `unknown`, more than any hits.
  static constexpr Hits some_undecided = Hits{1} << most_hits;

  static constexpr std::uint32_t batch_size = 64;

  /// Tells whether to write in each vector of such long rows costs more than to list those with
  /// hits.
  [[nodiscard]] static HWY_INLINE bool hits_are_few(std::size_t hits, std::size_t own,
                                                    std::size_t size) {
    return size >= 64 && hits * 4 * lanes < own * size;
  }

  /// First the distances of all, then the pairs: two loops that do not wait for each other, each
  /// short enough for the processor to have several elements under way.
  template <class RunsOf>
  HWY_INLINE void test_batch(std::uint32_t first, std::uint32_t last, RunsOf runs_of) {
    static_assert(most_hits < 63);
    Hits hits[batch_size];
    for (std::uint32_t p = first; p < last; ++p) hits[p - first] = hits_among(p, runs_of(p));
    std::size_t found = hits_.found;
    for (std::uint32_t p = first; p < last; ++p) {
      const Hits own = hits[p - first];
      if (own == 0) continue;
      if (HWY_UNLIKELY(found + most_hits > HitBuffer::size)) {
        hits_.found = found;
        take();
        found = 0;
      }
      if (HWY_LIKELY(own < some_undecided)) {
        found += write(p, own, runs_of(p), found);
      } else if (own == some_undecided) {
        found += write_undecided(p, runs_of(p), found);
      } else {
        hits_.found = found;
        if (!test_long_runs(p, runs_of(p))) test_with_care(p, runs_of);
        take_now_and_then();
        found = hits_.found;
      }
    }
    hits_.found = found;
  }

  template <class Runs>
  HWY_INLINE Hits hits_among(std::uint32_t p, const Runs& runs) {
    static_assert(Runs::size() * short_run <= most_hits);
    const Probe probe = probe_of(p);
    Mask undecided = hn::MaskFromVec(hn::Zero(floats));
    std::uint64_t spare_lanes = 0;  // near a multiple of 2^32 once a run is too long
    Hits hits = 0;
    for (std::size_t r = 0; r < Runs::size(); ++r) {
      const Run run = runs[r];
      const std::uint32_t spare = short_run + run.begin - run.end;
      spare_lanes += spare;
      for (std::size_t k = 0; k < short_run; k += lanes) {
        const Filtered filtered = probe.filter(sorted_, run.begin + k);
        undecided = hn::Or(undecided, hn::AndNot(filtered.sure, filtered.hit));
        Hits found = bits_of(filtered.hit);
        if constexpr (!Runs::harmless_beyond) found &= all_of_short_run >> (spare & 31u) >> k;
        hits |= found << (8 * r + k);
      }
    }
    constexpr std::size_t lanes_of_all = Runs::size() * short_run;
    if (HWY_UNLIKELY(spare_lanes > lanes_of_all)) return unknown;
    candidate_tests_ += lanes_of_all - spare_lanes;
    return HWY_LIKELY(hn::AllFalse(floats, undecided)) ? hits : some_undecided;
  }

  /// Writes like `write` for an element whose runs are short and that has undecided hits. Lanes
  /// beyond a run are never among these.
  template <class Runs>
  HWY_NOINLINE std::size_t write_undecided(std::uint32_t p, const Runs& runs, std::size_t place) {
    const Probe probe = probe_of(p);
    Hits hits = 0;
    Hits undecided_count = 0;
    for (std::size_t r = 0; r < Runs::size(); ++r) {
      const Run run = runs[r];
      const Hits within = all_of_short_run >> (short_run + run.begin - run.end);
      for (std::size_t k = 0; k < short_run; k += lanes) {
        const Filtered filtered = probe.filter(sorted_, run.begin + k);
        const Hits hit = (Hits{bits_of(filtered.hit)} << k) & within;
        hits |= hit << (8 * r);
        undecided_count |= (hit & ~(Hits{bits_of(filtered.sure)} << k)) << (8 * r);
      }
    }
    note_undecided(hits_, hits, undecided_count, place);
    return write(p, hits, runs, place);
  }

  /// Writes the element's hits to that place of the buffer and returns how many there are. Whole
  /// vectors: the excess is overwritten.
  template <class Runs>
  HWY_INLINE std::size_t write(std::uint32_t p, Hits hits, const Runs& runs,
                               std::size_t place) const {
    const std::uint32_t* const number = sorted_.number;
    std::uint32_t* const begin = partner_ + place;
    std::uint32_t* end = begin;
    for (std::size_t r = 0; r < Runs::size(); ++r) {
      const std::size_t q = runs[r].begin;
      for (std::size_t k = 0; k < short_run; k += lanes) {
        const Bits set = static_cast<Bits>(hits >> (8 * r + k)) & all_lanes;
        hn::StoreU(compress(hn::LoadU(numbers, number + q + k), set), numbers, end);
        end += std::popcount(set);
      }
    }
    const auto count = static_cast<std::size_t>(end - begin);
    const Numbers own = hn::Set(numbers, number[p]);
    for (std::size_t k = 0; k < count; k += lanes) hn::StoreU(own, numbers, element_ + place + k);
    return count;
  }

  template <class Runs>
  HWY_NOINLINE bool test_long_runs(std::uint32_t p, const Runs& runs) {
    return test_runs(probe_of(p), runs);
  }

  /// A run that is long or has a hit.
  HWY_NOINLINE void test_run(std::uint32_t p, Run run) {
    const Probe probe = probe_of(p);
    if (!test_runs(probe, RunList{std::span(&run, 1)})) test_with_care(probe, run);
  }

  /// Runs of any length. Returns false, having found nothing, where the filter cannot decide
  /// everything, or where they do not fit into the hits.
  template <class Runs>
  HWY_INLINE bool test_runs(const Probe& probe, const Runs& runs) {
    std::size_t size = 0;
    for (std::size_t r = 0; r < runs.size(); ++r) size += runs[r].end - runs[r].begin;
    if (size + lanes > HitBuffer::size) return false;
    make_room(size + lanes);
    Row row(partner_ + hits_.found);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const Run run = runs[r];
      for (std::size_t q = run.begin; q < run.end; q += lanes) {
        const std::size_t left = run.end - q;
        const bool whole = Runs::harmless_beyond || left >= lanes;
        row.write_all(probe, sorted_, q, whole ? all_lanes : (1u << left) - 1);
      }
    }
    if (!commit(probe, row)) return false;
    candidate_tests_ += size;
    return true;
  }

  /// An element with runs of any length, and notes of what the filter cannot decide.
  template <class RunsOf>
  HWY_NOINLINE void test_with_care(std::uint32_t p, RunsOf runs_of) {
    const Probe probe = probe_of(p);
    const auto runs = runs_of(p);
    for (std::size_t r = 0; r < runs.size(); ++r) test_with_care(probe, runs[r]);
  }

  HWY_INLINE Probe probe_of(std::uint32_t p) const { return Probe(tile_, job_, p); }

  /// Vectors begin at multiples of their length, so that elements of one block take equally many
  /// turns, which the processor foresees. Returns false, having found nothing, where the filter
  /// cannot decide everything.
  HWY_INLINE bool test_gathered(std::uint32_t p, std::size_t first, std::size_t size) {
    const Probe probe = probe_of(p);
    const Columns columns = block_.columns();
    Row row(partner_ + hits_.found);
    const std::size_t begin = first / lanes * lanes;
    row.write_all(probe, columns, begin, all_lanes << first % lanes & all_lanes);
    for (std::size_t q = begin + lanes; q < size; q += lanes) {
      row.write_all(probe, columns, q, all_lanes);
    }
    return commit(probe, row);
  }

  /// The same where few vectors have hits: these are listed for many elements before their hits are
  /// written.
  HWY_INLINE void test_block_with_few_hits(std::uint32_t own, std::uint32_t begin,
                                           std::size_t size) {
    VectorList left;
    std::size_t count = 0;
    std::size_t hits = 0;
    const auto write = [&]() HWY_ATTR {
      hits += write_hits(left, count);
      count = 0;
    };
    const std::uint32_t end = std::min(own, static_cast<std::uint32_t>(size) - 1);
    for (std::uint32_t k = 0; k < end; ++k) {
      if (HWY_UNLIKELY(count + Block::most_vectors(size) > VectorList::most)) write();
      count = block_.list(tile_, job_, begin + k, k + 1, size, left, count);
      candidate_tests_ += size - (k + 1);
      if (HWY_UNLIKELY(candidate_tests_ >= tests_between_takes)) {
        write();
        take();
      }
    }
    write();
    expects_few_hits_ = hits_are_few(hits, own, size);
  }

  /// Returns the number of hits.
  HWY_NOINLINE std::size_t write_hits(const VectorList& left, std::size_t count) {
    std::size_t written = 0;
    for (std::size_t n = 0; n < count; ++n) {
      const Probe probe = probe_of(left.element[n]);
      make_room(wide_lanes + lanes);
      for (std::size_t k = 0; k < wide_lanes; k += lanes) {
        const std::size_t q = left.candidates[n] + k;
        const Bits hits = left.hits[n] >> k & all_lanes;
        const Filtered filtered = probe.filter(block_.columns(), q);
        write_lanes(probe, block_.columns(), q, hits, bits_of(filtered.sure));
        written += static_cast<std::size_t>(std::popcount(hits));
      }
    }
    return written;
  }

  /// Takes a row that was written behind the hits, unless some of it is undecided.
  HWY_INLINE bool commit(const Probe& probe, const Row& row) {
    if (HWY_UNLIKELY(!row.is_decided())) return false;
    const auto count = static_cast<std::size_t>(row.end() - (partner_ + hits_.found));
    for (std::size_t k = 0; k < count; k += lanes) {
      hn::StoreU(probe.number(), numbers, element_ + hits_.found + k);
    }
    hits_.found += count;
    return true;
  }

  HWY_INLINE void make_room(std::size_t count) {
    if (HWY_UNLIKELY(hits_.found + count > HitBuffer::size)) take();
  }

  HWY_NOINLINE void take() {
    job_.candidate_tests += std::exchange(candidate_tests_, 0);
    job_.take(job_);
  }

  HWY_INLINE void test_with_care(const Probe& probe, const Run& run) {
    candidate_tests_ += run.end - run.begin;
    test_with_care(probe, sorted_, run.begin, run.end);
  }

  /// Candidates [first, last), in pieces for which there is room.
  HWY_NOINLINE void test_with_care(const Probe& probe, const Columns& columns, std::size_t first,
                                   std::size_t last) {
    constexpr std::size_t longest_piece = HitBuffer::size / 4;
    for (; first < last; first += longest_piece) {
      const std::size_t end = std::min(last, first + longest_piece);
      if (hits_.found + (end - first) > HitBuffer::size) take();
      test_piece(probe, columns, first, end);
    }
  }

  HWY_INLINE void test_piece(const Probe& probe, const Columns& columns, std::size_t begin,
                             std::size_t end) {
    for (std::size_t q = begin; q < end; q += lanes) {
      const Filtered filtered = probe.filter(columns, q);
      const Bits within = end - q < lanes ? (1u << (end - q)) - 1 : all_lanes;
      write_lanes(probe, columns, q, bits_of(filtered.hit) & within, bits_of(filtered.sure));
    }
  }

  /// The hits in the vector from q on, with notes of those that are not sure.
  HWY_INLINE void write_lanes(const Probe& probe, const Columns& columns, std::size_t q, Bits hits,
                              Bits sure) {
    const std::size_t found = hits_.found;
    if (HWY_UNLIKELY((hits & ~sure) != 0)) note_undecided(hits_, hits, hits & ~sure, found);
    hn::StoreU(probe.number(), numbers, element_ + found);
    hn::StoreU(compress(hn::LoadU(numbers, columns.number + q), hits), numbers, partner_ + found);
    hits_.found = found + static_cast<std::size_t>(std::popcount(hits));
  }

  const TileView& tile_;
  SearchJob& job_;
  HitBuffer& hits_;
  Columns sorted_;  ///< the tile's
  Block block_;
  std::uint32_t* element_;
  std::uint32_t* partner_;
  std::size_t candidate_tests_ = 0;
  bool expects_undecided_count_ = false;  ///< the last element of a block had some, as on a lattice
  bool expects_few_hits_ = false;         ///< the last block had
};
