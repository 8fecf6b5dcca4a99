// The elements of a layer and their candidates in vectors, included like
// simd_joined_runs-inl.hpp.

template <int Dim, class Reach>
class SimdLayerTester {
 public:
  HWY_INLINE SimdLayerTester(const LayerPair& layers, SearchJob& job)
      : layers_(layers),
        job_(job),
        hits_(*job.hits),
        band_(hn::BitCast(numbers, hn::Set(floats, layers.band))) {}

  HWY_INLINE void search() {
    // Places are those of these layers: undecided pairs of others, or for others, are taken.
    if (layers_.copies != nullptr && hits_.undecided_count > 0) take();
    hits_.copies = layers_.copies;
    for (std::uint32_t row = 1; row <= layers_.rows; ++row) {
      const RunsOfRow<Dim> ahead(layers_, row);
      const Run elements = ahead.elements();
      for (std::uint32_t p = elements.begin; p < elements.end; p += batch_size) {
        test_batch(ahead, {p, std::min(elements.end, p + batch_size)});
        take_now_and_then();
      }
    }
    if (layers_.copies != nullptr && hits_.undecided_count > 0) take();
    hits_.copies = nullptr;
    job_.candidate_tests += std::exchange(candidate_tests_, 0);
    job_.has_many_undecided = expects_care_;
  }

 private:
  static constexpr std::uint32_t batch_size = 64;
  static constexpr std::uint32_t vectors = Dim == 2 ? 1 : 3;
  static constexpr std::uint32_t most_hits = vectors * candidates;

  /// In place of hits: the runs are too long for their vectors, or the filter leaves some
  /// undecided.
  static constexpr Bits with_care = Bits{1} << 31;

  /// The candidates of the elements of a batch, and which of them are hits: bit 8 v + k for lane k
  /// of vector v.
  struct Batch {
    std::uint32_t number[batch_size][most_hits];
    Bits hits[batch_size];
  };

  /// First the distances of all, then the pairs: two loops that do not wait for each other, each
  /// short enough for the processor to have several elements under way. Neither branches on what
  /// is common.
  HWY_INLINE void test_batch(const RunsOfRow<Dim>& ahead, const Run& elements) {
    if (HWY_UNLIKELY(expects_care_)) return test_batch_with_care(ahead, elements);
    Batch batch;
    std::uint64_t tests = 0;
    std::uint32_t number_with_care = 0;
    for (std::uint32_t k = 0; k < elements.end - elements.begin; ++k) {
      batch.hits[k] = filter(ahead, elements.begin + k, batch.number[k], tests);
    }
    candidate_tests_ += tests;
    std::size_t found = hits_.found;
    for (std::uint32_t k = 0; k < elements.end - elements.begin; ++k) {
      const Bits hits = batch.hits[k];
      if (hits == 0) continue;
      if (HWY_UNLIKELY(hits >= with_care)) {
        hits_.found = found;
        test_with_care(ahead, elements.begin + k);
        take_now_and_then();
        found = hits_.found;
        ++number_with_care;
        continue;
      }
      if (HWY_UNLIKELY(found + most_hits > HitBuffer::size)) {
        hits_.found = found;
        take();
        found = hits_.found;
      }
      found += write(elements.begin + k, hits, batch.number[k], found);
    }
    hits_.found = found;
    expects_care_ = is_most(number_with_care, elements);
  }

  /// Returns the hits, or some number from `with_care` on; adds the tests that need no care.
  HWY_INLINE Bits filter(const RunsOfRow<Dim>& ahead, std::uint32_t p, std::uint32_t* number,
                         std::uint64_t& tests) const {
    const std::uint32_t column = layers_.column[p];
    LayerProbe probe(layers_, p);
    const JoinedRuns first(ahead.template run<0>(p, column), ahead.template run<1>(p, column));
    Bits hits = probe.test(first, number);
    std::uint32_t size = first.size();
    std::uint32_t excess = first.size() + (candidates - 1);
    if constexpr (Dim == 3) {
      const JoinedRuns second(ahead.template run<2>(p, column), ahead.template run<3>(p, column));
      const SingleRun third(ahead.template run<4>(p, column));
      hits |= probe.test(second, number + candidates) << candidates;
      hits |= probe.test(third, number + 2 * candidates) << (2 * candidates);
      size += second.size() + third.size();
      excess |= (second.size() + (candidates - 1)) | (third.size() + (candidates - 1));
    }
    const auto needs_care =
        static_cast<std::uint32_t>((excess >= 2 * candidates) | !probe.is_decided(band_));
    tests += size & (needs_care - 1);
    return hits | needs_care * with_care;
  }

  /// One element in all lanes.
  class LayerProbe {
   public:
    HWY_INLINE LayerProbe(const LayerPair& layers, std::uint32_t p)
        : layers_(layers), reach_(layers, p), nearest_(hn::Set(numbers, ~std::uint32_t{0})) {
      for (int axis = 0; axis < Dim; ++axis) {
        position_[axis] = hn::Set(integers, layers.position[axis][p]);
      }
    }

    /// The candidates that are certainly within reach; writes down the numbers of all.
    template <class Runs>
    HWY_INLINE Bits test(const Runs& runs, std::uint32_t* number) {
      Bits hits = 0;
      for (std::size_t k = 0; k < candidates; k += lanes) {
        const Floats beyond = hn::Sub(distance_squared(runs, k), reach_.inner(runs, k));
        hits |= bits_of(hn::Lt(beyond, hn::Zero(floats))) << k;
        // As whole numbers without a sign, negative floats are the largest.
        nearest_ = hn::Min(nearest_, hn::BitCast(numbers, beyond));
        hn::StoreU(runs.load(numbers, layers_.number, k), numbers, number + k);
      }
      return hits;
    }

    /// Tells whether none is as little beyond the inner bound as `band`.
    [[nodiscard]] HWY_INLINE bool is_decided(Numbers band) const {
      return hn::AllFalse(numbers, hn::Eq(hn::Min(nearest_, band), nearest_));
    }

    template <class Runs>
    [[nodiscard]] HWY_INLINE Floats distance_squared(const Runs& runs, std::size_t k) const {
      Floats sum = hn::Zero(floats);
      for (int axis = 0; axis < Dim; ++axis) {
        const Floats difference = hn::ConvertTo(
            floats, hn::Sub(runs.load(integers, layers_.position[axis], k), position_[axis]));
        const Floats square = hn::Mul(difference, difference);
        sum = axis == 0 ? square : hn::Add(sum, square);
      }
      return sum;
    }

    [[nodiscard]] HWY_INLINE const Reach& reach() const { return reach_; }

   private:
    const LayerPair& layers_;
    Reach reach_;
    Numbers nearest_;
    Integers position_[Dim];
  };

  /// Writes the hits to that place of the buffer and returns how many there are. Whole vectors: the
  /// excess is overwritten.
  HWY_INLINE std::size_t write(std::uint32_t p, Bits hits, const std::uint32_t* number,
                               std::size_t place) const {
    std::uint32_t* const begin = hits_.partner + place;
    std::uint32_t* end = begin;
    for (std::size_t k = 0; k < most_hits; k += lanes) {
      const Bits set = hits >> k & all_lanes;
      hn::StoreU(compress(hn::LoadU(numbers, number + k), set), numbers, end);
      end += std::popcount(set);
    }
    const auto count = static_cast<std::size_t>(end - begin);
    const Numbers own = hn::Set(numbers, layers_.number[p]);
    for (std::size_t k = 0; k < count; k += lanes) {
      hn::StoreU(own, numbers, hits_.element + place + k);
    }
    return count;
  }

  /// The elements of a batch most of which have an undecided pair, as on a lattice.
  HWY_NOINLINE void test_batch_with_care(const RunsOfRow<Dim>& ahead, const Run& elements) {
    std::uint32_t number_with_care = 0;
    for (std::uint32_t p = elements.begin; p < elements.end; ++p) {
      const std::size_t undecided_before = hits_.undecided_count;
      test_with_care(ahead, p);
      number_with_care += hits_.undecided_count != undecided_before ? 1 : 0;
      take_now_and_then();
    }
    expects_care_ = is_most(number_with_care, elements);
  }

  [[nodiscard]] static HWY_INLINE bool is_most(std::uint32_t count, const Run& elements) {
    return 2 * count > elements.end - elements.begin;
  }

  /// An element with runs of any length, and notes of what the filter cannot decide.
  HWY_NOINLINE void test_with_care(const RunsOfRow<Dim>& ahead, std::uint32_t p) {
    const std::uint32_t column = layers_.column[p];
    const LayerProbe probe(layers_, p);
    test_two_runs(probe, p, ahead.template run<0>(p, column), ahead.template run<1>(p, column));
    if constexpr (Dim == 3) {
      test_two_runs(probe, p, ahead.template run<2>(p, column), ahead.template run<3>(p, column));
      test_lanes(probe, p, SingleRun(ahead.template run<4>(p, column)));
    }
  }

  HWY_INLINE void test_two_runs(const LayerProbe& probe, std::uint32_t p, const Run& first,
                                const Run& second) {
    const JoinedRuns joined(first, second);
    if (HWY_LIKELY(joined.size() <= candidates)) return test_lanes(probe, p, joined);
    test_lanes(probe, p, SingleRun(first));
    test_lanes(probe, p, SingleRun(second));
  }

  template <class Runs>
  HWY_INLINE void test_lanes(const LayerProbe& probe, std::uint32_t p, const Runs& runs) {
    candidate_tests_ += runs.size();
    for (std::uint32_t k = 0; k < runs.size(); k += lanes) {
      if (HWY_UNLIKELY(hits_.found + lanes > HitBuffer::size)) take();
      const Floats distance_squared = probe.distance_squared(runs, k);
      const std::uint32_t left = runs.size() - k;
      const Bits within = left < lanes ? (1u << left) - 1 : all_lanes;
      const auto is_hit = hn::Le(distance_squared, probe.reach().outer(runs, k));
      const auto is_sure = hn::Lt(distance_squared, probe.reach().inner(runs, k));
      const Bits hits = bits_of(is_hit) & within;
      note_undecided(hits, hn::VecFromMask(numbers, hn::RebindMask(numbers, hn::Not(is_sure))), p,
                     runs.places(k));
      hn::StoreU(hn::Set(numbers, layers_.number[p]), numbers, hits_.element + hits_.found);
      hn::StoreU(compress(runs.load(numbers, layers_.number, k), hits), numbers,
                 hits_.partner + hits_.found);
      hits_.found += static_cast<std::size_t>(std::popcount(hits));
    }
  }

  /// Notes the places of the undecided ones among the hits that are about to be written. Without a
  /// branch: the excess is overwritten.
  HWY_INLINE void note_undecided(Bits hits, Numbers is_undecided, std::uint32_t p,
                                 Numbers partners) {
    const Bits written = (1u << std::popcount(hits)) - 1;
    const auto in_order = hn::Ne(compress(is_undecided, hits), hn::Zero(numbers));
    const Bits undecided = bits_of(hn::RebindMask(floats, in_order)) & written;
    const std::size_t count = hits_.undecided_count;
    const Numbers place = numbers_from(static_cast<std::uint32_t>(hits_.found));
    hn::StoreU(compress(place, undecided), numbers, hits_.undecided + count);
    if (layers_.copies != nullptr) {
      hn::StoreU(hn::Set(numbers, p), numbers, hits_.element_place + count);
      hn::StoreU(compress(compress(partners, hits), undecided), numbers,
                 hits_.partner_place + count);
    }
    hits_.undecided_count += static_cast<std::size_t>(std::popcount(undecided));
  }

  HWY_INLINE void take_now_and_then() {
    if (HWY_UNLIKELY(candidate_tests_ >= tests_between_takes)) take();
  }

  HWY_NOINLINE void take() {
    job_.candidate_tests += std::exchange(candidate_tests_, 0);
    job_.take(job_);
  }

  const LayerPair& layers_;
  SearchJob& job_;
  HitBuffer& hits_;
  Numbers band_;
  std::uint64_t candidate_tests_ = 0;
  bool expects_care_ = false;
};
