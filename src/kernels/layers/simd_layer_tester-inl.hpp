// The elements of a layer and their candidates in vectors, included like
// simd_joined_runs-inl.hpp.

/// Elements that meet what is ahead of them: in their own layer and the next one.
template <int Dim, class ProbeOfElement>
class AheadSearch {
 public:
  using Layers = LayerPair;
  using Probe = ProbeOfElement;
  using Row = RunsOfRow<Dim>;
  static constexpr std::size_t runs = Row::size;
  /// Tells whether it cannot be foreseen which elements have hits, so that they are listed.
  static constexpr bool some_have_hits = false;

  /// Some elements of a row that stand together.
  class Batch {
   public:
    HWY_INLINE Batch(const LayerPair& layers, const Row& row, const Run& elements)
        : layers_(layers), row_(row), elements_(elements) {}

    [[nodiscard]] HWY_INLINE std::uint32_t size() const { return elements_.end - elements_.begin; }
    [[nodiscard]] HWY_INLINE std::uint32_t place(std::uint32_t k) const {
      return elements_.begin + k;
    }

    class RunsAhead {
     public:
      HWY_INLINE RunsAhead(const Row& row, std::uint32_t p, std::uint32_t column)
          : row_(row), p_(p), column_(column) {}
      template <std::size_t k>
      [[nodiscard]] HWY_INLINE Run run() const {
        return row_.template run<k>(p_, column_);
      }

     private:
      const Row& row_;
      std::uint32_t p_;
      std::uint32_t column_;
    };
    [[nodiscard]] HWY_INLINE RunsAhead runs_of(std::uint32_t k) const {
      return {row_, place(k), layers_.column[place(k)]};
    }

   private:
    const LayerPair& layers_;
    const Row& row_;
    Run elements_;
  };
};

/// Near elements that look for smaller ones around them.
template <int Dim>
class NearSearch {
 public:
  using Layers = ThreeLayers;
  using Probe = LayerProbe<Dim, SmallerReach>;
  using Row = ElementsOfRow;
  static constexpr std::size_t runs = NearBatch<Dim>::runs;
  static constexpr bool some_have_hits = true;

  class Batch : public NearBatch<Dim> {
   public:
    HWY_INLINE Batch(const ThreeLayers& layers, const Row&, const Run& elements)
        : NearBatch<Dim>(layers, elements) {}
  };
};

template <class Search>
class SimdLayerTester {
 public:
  using Layers = typename Search::Layers;

  HWY_INLINE SimdLayerTester(const Layers& layers, SearchJob& job)
      : layers_(layers),
        job_(job),
        hits_(layers, job),
        band_(hn::BitCast(numbers, hn::Set(floats, layers.band))) {}

  HWY_INLINE void search() {
    for (std::uint32_t row = 1; row <= layers_.rows; ++row) {
      const typename Search::Row row_of(layers_, row);
      const Run elements = row_of.elements();
      for (std::uint32_t p = elements.begin; p < elements.end; p += batch_size) {
        test_batch({layers_, row_of, {p, std::min(elements.end, p + batch_size)}});
        hits_.take_now_and_then();
      }
    }
    hits_.finish();
    job_.has_many_undecided = has_many_undecided_;
  }

 private:
  using Probe = typename Search::Probe;

  static constexpr std::uint32_t batch_size = 64;
  static constexpr std::size_t vectors = (Search::runs + 1) / 2;
  static constexpr std::size_t most_hits = vectors * candidates;

  /// In place of hits: the runs are too long for their vectors, or the filter leaves some
  /// undecided.
  static constexpr Bits with_care = Bits{1} << 31;

  /// Candidates of a run, more than which are those of a crowd.
  static constexpr auto long_run = 2 * static_cast<std::uint32_t>(lanes);

  using Elements = typename Search::Batch;

  /// The candidates of the elements of a batch, and which of them are hits: bit 8 v + k for lane k
  /// of vector v.
  struct Batch {
    std::uint32_t number[batch_size][most_hits];
    Bits hits[batch_size];
    std::uint32_t with_hits[batch_size + 1];  ///< those that have some
    std::uint32_t count = 0;                  ///< of these
  };

  /// How many elements of a batch needed care, and of these had an undecided pair.
  struct BatchCounts {
    std::uint32_t elements = 0;
    std::uint32_t undecided = 0;
  };

  /// First the distances of all, then the pairs: two loops that do not wait for each other, each
  /// short enough for the processor to have several elements under way. Neither branches on what
  /// is common.
  HWY_INLINE void test_batch(const Elements& elements) {
    if (HWY_UNLIKELY(expects_care_)) return test_batch_with_care(elements);
    Batch batch;
    std::uint64_t tests = 0;
    BatchCounts counts;
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      batch.hits[k] = filter(elements, k, batch.number[k], tests);
      if constexpr (Search::some_have_hits) {
        batch.with_hits[batch.count] = k;
        batch.count += batch.hits[k] != 0 ? 1 : 0;
      }
    }
    hits_.count_tests(tests);
    std::size_t found = hits_.found();
    const std::uint32_t count = Search::some_have_hits ? batch.count : elements.size();
    for (std::uint32_t n = 0; n < count; ++n) {
      const std::uint32_t k = Search::some_have_hits ? batch.with_hits[n] : n;
      const Bits hits = batch.hits[k];
      if (!Search::some_have_hits && hits == 0) continue;
      if (HWY_UNLIKELY(hits >= with_care)) {
        hits_.set_found(found);
        test_with_care(elements, k, counts);
        found = hits_.found();
        continue;
      }
      found = hits_.make_room(found, most_hits);
      found += hits_.template write<most_hits>(layers_.number[elements.place(k)], hits,
                                               batch.number[k], found);
    }
    hits_.set_found(found);
    expect(counts, elements);
  }

  /// Returns the hits, or some number from `with_care` on; adds the tests that need no care.
  HWY_INLINE Bits filter(const Elements& elements, std::uint32_t k, std::uint32_t* number,
                         std::uint64_t& tests) const {
    const auto runs = elements.runs_of(k);
    Probe probe = Probe::at(layers_, elements.place(k));
    VectorHits all;
    filter_vector<0>(probe, runs, number, all);
    if constexpr (vectors > 1) filter_vector<1>(probe, runs, number, all);
    if constexpr (vectors > 2) filter_vector<2>(probe, runs, number, all);
    const auto needs_care =
        static_cast<std::uint32_t>((all.excess >= 2 * candidates) | !probe.is_decided(band_));
    tests += all.size & (needs_care - 1);
    return all.hits | needs_care * with_care;
  }

  /// What the vectors of an element have come to.
  struct VectorHits {
    Bits hits = 0;
    std::uint32_t size = 0;
    std::uint32_t excess = 0;  ///< 2 candidates or more where one of them has too many
  };

  template <std::size_t v, class Runs>
  static HWY_INLINE void filter_vector(Probe& probe, const Runs& runs, std::uint32_t* number,
                                       VectorHits& all) {
    const auto lanes_of = [&](const auto& joined) {
      all.hits |= probe.test(joined, number + v * candidates) << (v * candidates);
      all.size += joined.size();
      all.excess |= joined.size() + (candidates - 1);
    };
    if constexpr (2 * v + 1 < Search::runs) {
      lanes_of(JoinedRuns(runs.template run<2 * v>(), runs.template run<2 * v + 1>()));
    } else {
      lanes_of(SingleRun(runs.template run<2 * v>()));
    }
  }

  /// The elements of a batch most of which need care, as on a lattice or in a crowd.
  HWY_NOINLINE void test_batch_with_care(const Elements& elements) {
    BatchCounts counts;
    for (std::uint32_t k = 0; k < elements.size(); ++k) test_with_care(elements, k, counts);
    expect(counts, elements);
  }

  /// From most of a batch to the next one.
  HWY_INLINE void expect(const BatchCounts& counts, const Elements& elements) {
    expects_care_ = 2 * counts.elements > elements.size();
    has_many_undecided_ = 2 * counts.undecided > elements.size();
  }

  HWY_INLINE void test_with_care(const Elements& elements, std::uint32_t k, BatchCounts& counts) {
    const std::size_t undecided_before = hits_.undecided_count();
    const bool has_long_runs = test_all_runs(elements, k);
    const bool has_undecided = hits_.undecided_count() != undecided_before;
    counts.elements += has_long_runs || has_undecided ? 1 : 0;
    counts.undecided += has_undecided ? 1 : 0;
    hits_.take_now_and_then();
  }

  /// An element with runs of any length, and notes of what the filter cannot decide. Returns
  /// whether runs are too long for their vectors.
  HWY_NOINLINE bool test_all_runs(const Elements& elements, std::uint32_t k) {
    const auto runs = elements.runs_of(k);
    const std::uint32_t p = elements.place(k);
    const Probe probe = Probe::at(layers_, p);
    bool are_long = test_runs<0>(probe, p, runs);
    if constexpr (vectors > 1) are_long |= test_runs<1>(probe, p, runs);
    if constexpr (vectors > 2) are_long |= test_runs<2>(probe, p, runs);
    return are_long;
  }

  template <std::size_t v, class Runs>
  HWY_INLINE bool test_runs(const Probe& probe, std::uint32_t p, const Runs& runs) {
    const Run first = runs.template run<2 * v>();
    if constexpr (2 * v + 1 < Search::runs) {
      const Run second = runs.template run<2 * v + 1>();
      const JoinedRuns joined(first, second);
      if (HWY_LIKELY(joined.size() <= candidates)) {
        test_lanes(probe, p, joined);
        return false;
      }
      test_single_run(probe, p, SingleRun(first));
      test_single_run(probe, p, SingleRun(second));
      return true;
    } else {
      test_single_run(probe, p, SingleRun(first));
      return first.end - first.begin > candidates;
    }
  }

  HWY_INLINE void test_single_run(const Probe& probe, std::uint32_t p, const SingleRun& run) {
    if (HWY_UNLIKELY(run.size() > long_run)) return test_long_run(probe, p, run);
    test_lanes(probe, p, run);
  }

  template <class Runs>
  HWY_INLINE void test_lanes(const Probe& probe, std::uint32_t p, const Runs& runs) {
    hits_.count_tests(runs.size());
    for (std::uint32_t k = 0; k < runs.size(); k += lanes) add_hits(probe, p, runs, k);
  }

  /// A run of a crowd. Most of its vectors have no hits: they are only looked at.
  HWY_INLINE void test_long_run(const Probe& probe, std::uint32_t p, const SingleRun& run) {
    constexpr std::uint32_t piece = 32 * static_cast<std::uint32_t>(lanes);
    hits_.count_tests(run.size());
    for (std::uint32_t begin = 0; begin < run.size(); begin += piece) {
      const std::uint32_t end = std::min(run.size(), begin + piece);
      std::uint32_t with_hits[piece / lanes + 1];
      std::uint32_t count = 0;
      for (std::uint32_t k = begin; k < end; k += lanes) {
        with_hits[count] = k;
        count += probe.hits(run, k, probe.distance_squared(run, k)) != 0 ? 1 : 0;
      }
      for (std::uint32_t n = 0; n < count; ++n) add_hits(probe, p, run, with_hits[n]);
    }
  }

  template <class Runs>
  HWY_INLINE void add_hits(const Probe& probe, std::uint32_t p, const Runs& runs, std::uint32_t k) {
    const auto squares = probe.distance_squared(runs, k);
    const Bits hits = probe.hits(runs, k, squares) & lanes_before(runs.size() - k);
    hits_.add(layers_.number[p], p, runs, k, hits, probe.is_sure(runs, k, squares));
  }

  const Layers& layers_;
  SearchJob& job_;
  LayerHits hits_;
  Numbers band_;
  bool expects_care_ = false;
  bool has_many_undecided_ = false;
};
