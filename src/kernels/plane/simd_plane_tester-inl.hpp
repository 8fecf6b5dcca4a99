// An element of a plane beside those of its runs, in vectors; included once for each instruction
// set into the namespace of plane_search_simd.cpp, whose names it uses: no include guard, and no
// includes.

/// Tests each element against its two runs. A vector may reach beyond the end of a run: what lies
/// there is of the same row, farther along it than the reach, or padding, and so never a hit.
///
/// Where few elements of a row have hits, a vector without any is passed by. Where many have, no
/// branch asks: neither hits can be foreseen, nor how many vectors a run takes, so that all runs of
/// a row take equally many, which hold most of them.
template <int Dim, ElementShape Shape>
class SimdPlaneTester {
  using Probe = SimdProbe<Dim, Shape>;

 public:
  HWY_INLINE SimdPlaneTester(const PlaneView& plane, SearchJob& job)
      : plane_(plane),
        job_(job),
        hits_(*job.hits),
        columns_{{plane.center[0], plane.center[1], plane.center[2]},
                 {plane.size[0], plane.size[1], plane.size[2]},
                 plane.number} {}

  HWY_INLINE void search() {
    bool has_few_hits = plane_.has_few_hits;
    for (std::uint32_t k = 0; k < plane_.rows; ++k) {
      const Run row = plane_.row(k);
      if (row.begin == row.end) continue;
      found_in_row_ = 0;
      if (has_few_hits) {
        test_row<true>(row, k + 1 < plane_.rows);
      } else {
        test_row<false>(row, k + 1 < plane_.rows);
      }
      const auto elements = static_cast<float>(row.end - row.begin);
      has_few_hits = static_cast<float>(found_in_row_) < few_hits_in_plane * elements;
    }
    job_.candidate_tests += std::exchange(candidate_tests_, 0);
  }

 private:
  /// One of so many elements tells how many vectors the runs of a row take.
  static constexpr std::uint32_t elements_of_sample = 8;

  /// Vectors that hold most of the runs of either kind.
  struct VectorCounts {
    std::size_t ahead;
    std::size_t across;
  };

  HWY_INLINE Run run_across(const PlaneView& plane, std::uint32_t p, std::uint32_t span,
                            bool has_next) const {
    return has_next ? plane.across(p, span) : Run{0, 0};
  }

  HWY_INLINE VectorCounts count_vectors(Run row, bool has_next) const {
    std::size_t ahead = 0;
    std::size_t across = 0;
    std::size_t sampled = 0;
    for (std::uint32_t p = row.begin; p < row.end; p += elements_of_sample, ++sampled) {
      const std::uint32_t span = plane_.span(p);
      ahead += plane_.ahead(p, span).size();
      across += run_across(plane_, p, span, has_next).size();
    }
    return {vectors_for(ahead / sampled), vectors_for(across / sampled)};
  }

  /// No vector of them reaches beyond the padding.
  static HWY_INLINE std::size_t vectors_for(std::size_t mean) {
    return std::min((mean + mean / 8 + lanes - 1) / lanes, plane_padding / lanes - 1);
  }

  /// What is read for each element stands in registers: no store can change it.
  template <bool HasFewHits>
  HWY_NOINLINE void test_row(Run row, bool has_next) {
    const PlaneView plane = plane_;
    const Columns columns = columns_;
    const VectorCounts vectors = HasFewHits ? VectorCounts{} : count_vectors(row, has_next);
    Probe probe(plane_, job_, row.begin);
    for (std::uint32_t p = row.begin; p < row.end; ++p) {
      const std::uint32_t span = plane.span(p);
      const Run ahead = plane.ahead(p, span);
      const Run across = run_across(plane, p, span, has_next);
      const std::size_t size = ahead.size() + across.size();
      candidate_tests_ += size;
      probe.move_to(columns, plane, job_, p);
      const std::size_t room = size + 2 * plane_padding;
      if (HWY_UNLIKELY(are_undecided_ || room > HitBuffer::size ||
                       !test<HasFewHits>(probe, columns, ahead, across, vectors, room))) {
        test_with_care(p, ahead, across);
      }
      if (HWY_UNLIKELY(candidate_tests_ >= tests_between_takes)) take();
    }
  }

  /// Returns false, having found nothing, where the filter cannot decide everything.
  template <bool HasFewHits>
  HWY_INLINE bool test(const Probe& probe, const Columns& columns, Run ahead, Run across,
                       const VectorCounts& vectors, std::size_t room) {
    if (HWY_UNLIKELY(hits_.found + room > HitBuffer::size)) take();
    const std::size_t found = hits_.found;
    std::uint32_t* const begin = hits_.partner + found;
    std::uint32_t* end = begin;
    Mask undecided = hn::MaskFromVec(hn::Zero(floats));
    if constexpr (HasFewHits) {
      end = write_some(probe, columns, ahead, end, undecided);
      end = write_some(probe, columns, across, end, undecided);
      if (end == begin) return true;
    } else {
      end = write_all(probe, columns, ahead, vectors.ahead, end, undecided);
      end = write_all(probe, columns, across, vectors.across, end, undecided);
    }
    if (HWY_UNLIKELY(!hn::AllFalse(floats, undecided))) return false;
    const auto count = static_cast<std::size_t>(end - begin);
    const Numbers number = hn::Set(numbers, columns.number[ahead.begin - 1]);
    for (std::size_t k = 0; k < count; k += lanes) {
      hn::StoreU(number, numbers, hits_.element + found + k);
    }
    hits_.found = found + count;
    found_in_row_ += count;
    return true;
  }

  /// Writes the hits of a run, most vectors of which have none, and returns where they end.
  static HWY_INLINE std::uint32_t* write_some(const Probe& probe, const Columns& columns, Run run,
                                              std::uint32_t* end, Mask& undecided) {
    for (std::size_t q = run.begin; q < run.end; q += lanes) {
      const Filtered filtered = probe.filter(columns, q);
      const Bits hits = bits_of(filtered.hit);
      if (hits == 0) continue;
      undecided = hn::Or(undecided, hn::AndNot(filtered.sure, filtered.hit));
      end = write_hits(columns, q, hits, end);
    }
    return end;
  }

  /// The same in so many vectors, or more if the run has more.
  static HWY_INLINE std::uint32_t* write_all(const Probe& probe, const Columns& columns, Run run,
                                             std::size_t vectors, std::uint32_t* end,
                                             Mask& undecided) {
    std::size_t q = run.begin;
    const auto write = [&]() HWY_ATTR {
      const Filtered filtered = probe.filter(columns, q);
      undecided = hn::Or(undecided, hn::AndNot(filtered.sure, filtered.hit));
      end = write_hits(columns, q, bits_of(filtered.hit), end);
      q += lanes;
    };
    for (std::size_t k = 0; k < vectors; ++k) write();
    while (HWY_UNLIKELY(q < run.end)) write();
    return end;
  }

  static HWY_INLINE std::uint32_t* write_hits(const Columns& columns, std::size_t q, Bits hits,
                                              std::uint32_t* end) {
    hn::StoreU(compress(hn::LoadU(numbers, columns.number + q), hits), numbers, end);
    return end + std::popcount(hits);
  }

  /// The same with notes of the pairs that are undecided. Where one element has some, so have most,
  /// as on a lattice.
  HWY_NOINLINE void test_with_care(std::uint32_t p, Run ahead, Run across) {
    const Probe probe(plane_, job_, p);
    are_undecided_ = false;
    note(probe, ahead);
    note(probe, across);
  }

  HWY_INLINE void note(const Probe& probe, Run run) {
    for (std::size_t q = run.begin; q < run.end; q += lanes) {
      const Filtered filtered = probe.filter(columns_, q);
      const Bits hits = bits_of(filtered.hit);
      if (hits == 0) continue;
      if (hits_.found + lanes > HitBuffer::size) take();
      const Bits undecided = hits & ~bits_of(filtered.sure);
      are_undecided_ = are_undecided_ || undecided != 0;
      note_undecided(hits_, hits, undecided, hits_.found);
      hn::StoreU(probe.number(), numbers, hits_.element + hits_.found);
      write_hits(columns_, q, hits, hits_.partner + hits_.found);
      const auto count = static_cast<std::size_t>(std::popcount(hits));
      hits_.found += count;
      found_in_row_ += count;
    }
  }

  HWY_NOINLINE void take() {
    job_.candidate_tests += std::exchange(candidate_tests_, 0);
    job_.take(job_);
  }

  const PlaneView& plane_;
  SearchJob& job_;
  HitBuffer& hits_;
  Columns columns_;
  std::size_t candidate_tests_ = 0;
  std::size_t found_in_row_ = 0;
  bool are_undecided_ = false;  ///< some of the last element's that was tested with care
};
