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
template <int Dim, class ProbeOfElement>
class NearSearch {
 public:
  using Layers = ThreeLayers;
  using Probe = ProbeOfElement;
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
  using Elements = typename Search::Batch;

  static constexpr std::uint32_t batch_size = 64;

  /// How the runs of an element fill vectors: two in each, or where many elements have too many
  /// candidates for that, each run its own.
  enum class Filling { joined, single };
  template <Filling filling>
  static constexpr std::size_t vectors_of = filling == Filling::joined ? (Search::runs + 1) / 2
                                                                       : Search::runs;

  /// One crowded element in so many costs more than vectors that are not joined.
  static constexpr std::uint32_t crowded_share = 5;

  /// In place of hits: the runs are too long for their vectors, or the filter leaves some
  /// undecided. An element of a crowd has the first bit alone.
  static constexpr HitBits with_care = HitBits{1} << 62;
  static constexpr HitBits with_undecided = HitBits{1} << 63;

  static constexpr Bits all_bits = ~Bits{0};

  /// Candidates of a run, more than which are those of a crowd.
  static constexpr auto long_run = 2 * static_cast<std::uint32_t>(lanes);

  /// The candidates of the elements of a batch, and which of them are hits: bit 8 v + k for lane k
  /// of vector v.
  template <Filling filling>
  struct Batch {
    static constexpr std::size_t most_hits = vectors_of<filling> * candidates;

    std::uint32_t number[batch_size][most_hits];
    HitBits hits[batch_size];
    std::uint32_t with_hits[batch_size + 1];  ///< those that have some
    std::uint32_t count = 0;                  ///< of these
  };

  /// What an element that was tested with care is like.
  struct ElementRuns {
    bool is_crowded = false;     ///< two joined runs are too long for a vector
    bool has_long_runs = false;  ///< one run is
    bool has_undecided = false;
  };

  /// The elements of a batch by what they are like.
  struct BatchCounts {
    std::uint32_t crowded = 0;
    std::uint32_t with_care = 0;  ///< those that vectors of single runs do not settle
    std::uint32_t undecided = 0;

    HWY_INLINE void add(const ElementRuns& its) {
      with_care += its.has_long_runs || its.has_undecided ? 1 : 0;
      undecided += its.has_undecided ? 1 : 0;
    }
  };

  HWY_INLINE void test_batch(const Elements& elements) {
    if (HWY_UNLIKELY(expects_care_)) return test_batch_with_care(elements);
    if (HWY_UNLIKELY(expects_crowd_)) return test_crowded_batch(elements);
    test_batch_as<Filling::joined>(elements);
  }

  HWY_NOINLINE void test_crowded_batch(const Elements& elements) {
    test_batch_as<Filling::single>(elements);
  }

  /// First the distances of all, then the pairs: two loops that do not wait for each other, each
  /// short enough for the processor to have several elements under way. Neither branches on what
  /// is common.
  template <Filling filling>
  HWY_INLINE void test_batch_as(const Elements& elements) {
    constexpr std::size_t most_hits = Batch<filling>::most_hits;
    Batch<filling> batch;
    std::uint64_t tests = 0;
    BatchCounts counts;
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      batch.hits[k] = filter<filling>(elements, k, batch.number[k], tests, counts);
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
      const HitBits hits = batch.hits[k];
      if (!Search::some_have_hits && hits == 0) continue;
      if (HWY_UNLIKELY(hits >= with_care)) {
        hits_.set_found(found);
        const ElementRuns its =
            hits >= with_undecided ? test_with_care(elements, k) : test_runs_of(elements, k);
        counts.add(its);
        if (filling == Filling::joined && its.is_crowded) ++counts.crowded;
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

  /// What the vectors of an element have come to.
  struct VectorHits {
    HitBits hits = 0;
    std::uint32_t size = 0;
    std::uint32_t excess = 0;         ///< 2 candidates or more where one of them has too many
    std::uint32_t joined_excess = 0;  ///< the same if runs were joined
    std::uint32_t size_of_last = 0;
  };

  /// Returns the hits, or some number from `with_care` on; adds the tests that need no care.
  template <Filling filling>
  HWY_INLINE HitBits filter(const Elements& elements, std::uint32_t k, std::uint32_t* number,
                            std::uint64_t& tests, BatchCounts& counts) const {
    const auto runs = elements.runs_of(k);
    Probe probe = Probe::at(layers_, elements.place(k));
    VectorHits all;
    filter_vectors<filling>(probe, runs, number, all,
                            std::make_index_sequence<vectors_of<filling>>());
    const auto is_crowded = static_cast<std::uint32_t>(all.excess >= 2 * candidates);
    const auto has_undecided = static_cast<std::uint32_t>(!probe.is_decided(band_));
    const std::uint32_t needs_care = is_crowded | has_undecided;
    tests += all.size & (needs_care - 1);
    if (filling == Filling::single) counts.crowded += all.joined_excess >= 2 * candidates ? 1 : 0;
    return all.hits | HitBits{is_crowded} * with_care | HitBits{has_undecided} * with_undecided;
  }

  template <Filling filling, class Runs, std::size_t... v>
  static HWY_INLINE void filter_vectors(Probe& probe, const Runs& runs, std::uint32_t* number,
                                        VectorHits& all, std::index_sequence<v...>) {
    (filter_vector<filling, v>(probe, runs, number, all), ...);
  }

  template <Filling filling, std::size_t v, class Runs>
  static HWY_INLINE void filter_vector(Probe& probe, const Runs& runs, std::uint32_t* number,
                                       VectorHits& all) {
    const auto lanes_of = [&](const auto& its, Bits mask) {
      const HitBits hits = probe.test(its, number + v * candidates) & mask;
      all.hits |= hits << (v * candidates);
      all.size += its.size();
      all.excess |= its.size() + (candidates - 1);
    };
    if constexpr (filling == Filling::single) {
      const SingleRun run(runs.template run<v>());
      // Behind an empty run may be what the next one has. Runs of more are tested with care.
      lanes_of(run, (Bits{1} << run.size() % 32) - 1);
      if constexpr (v % 2 == 1) {
        all.joined_excess |= all.size_of_last + run.size() + (candidates - 1);
      }
      all.size_of_last = run.size();
    } else if constexpr (2 * v + 1 < Search::runs) {
      lanes_of(JoinedRuns(runs.template run<2 * v>(), runs.template run<2 * v + 1>()), all_bits);
    } else {
      lanes_of(SingleRun(runs.template run<2 * v>()), all_bits);
    }
  }

  /// An element with more candidates than its vectors hold, if none is undecided and there are not
  /// very many. Otherwise this has no effect.
  HWY_NOINLINE bool test_crowded(const Elements& elements, std::uint32_t k, ElementRuns& its) {
    const auto runs = elements.runs_of(k);
    const std::uint32_t p = elements.place(k);
    RunPieces<Search::runs> pieces;
    add_all(pieces, runs, std::make_index_sequence<Search::runs>());
    if (pieces.is_large()) return false;
    Probe probe = Probe::at(layers_, p);
    const std::size_t found = hits_.make_room(hits_.found(), pieces.most * candidates);
    std::size_t end = found;
    for (std::uint32_t n = 0; n < pieces.size(); ++n) {
      std::uint32_t number[candidates];
      // What stands behind a run that is not empty is out of reach, or padding.
      const HitBits hits = probe.test(pieces[n], number);
      end += hits_.template write_partners<candidates>(hits, number, end);
    }
    if (!probe.is_decided(band_)) return false;
    hits_.write_element(layers_.number[p], found, end - found);
    hits_.set_found(end);
    hits_.count_tests(pieces.tests());
    its = {true, pieces.has_long_runs(), false};
    return true;
  }

  template <class Runs, std::size_t... r>
  static HWY_INLINE void add_all(RunPieces<Search::runs>& pieces, const Runs& runs,
                                 std::index_sequence<r...>) {
    (pieces.add(runs.template run<r>()), ...);
  }

  /// The elements of a batch most of which need care, as on a lattice or in a crowd.
  HWY_NOINLINE void test_batch_with_care(const Elements& elements) {
    BatchCounts counts;
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      const ElementRuns its = test_runs_of(elements, k);
      counts.add(its);
      if (its.is_crowded) ++counts.crowded;
    }
    expect(counts, elements);
  }

  /// From most of a batch to the next one.
  HWY_INLINE void expect(const BatchCounts& counts, const Elements& elements) {
    expects_care_ = 2 * counts.with_care > elements.size();
    expects_crowd_ = crowded_share * counts.crowded > elements.size();
    has_many_undecided_ = 2 * counts.undecided > elements.size();
  }

  /// An element that the vectors of its batch do not settle.
  HWY_INLINE ElementRuns test_runs_of(const Elements& elements, std::uint32_t k) {
    ElementRuns its;
    if (!has_many_undecided_ && test_crowded(elements, k, its)) return its;
    return test_with_care(elements, k);
  }

  /// An element with runs of any length, and notes of what the filter cannot decide.
  HWY_NOINLINE ElementRuns test_with_care(const Elements& elements, std::uint32_t k) {
    const std::size_t undecided_before = hits_.undecided_count();
    const auto runs = elements.runs_of(k);
    const std::uint32_t p = elements.place(k);
    const Probe probe = Probe::at(layers_, p);
    ElementRuns its;
    test_runs<0>(probe, p, runs, its);
    if constexpr (Search::runs > 2) test_runs<2>(probe, p, runs, its);
    if constexpr (Search::runs > 4) test_runs<4>(probe, p, runs, its);
    its.has_undecided = hits_.undecided_count() != undecided_before;
    hits_.take_now_and_then();
    return its;
  }

  /// The run r and the next one, if there is one.
  template <std::size_t r, class Runs>
  HWY_INLINE void test_runs(const Probe& probe, std::uint32_t p, const Runs& runs,
                            ElementRuns& its) {
    const Run first = runs.template run<r>();
    if constexpr (r + 1 < Search::runs) {
      const Run second = runs.template run<r + 1>();
      const JoinedRuns joined(first, second);
      if (HWY_LIKELY(joined.size() <= candidates)) return test_lanes(probe, p, joined);
      its.is_crowded = true;
      test_single_run(probe, p, SingleRun(first), its);
      test_single_run(probe, p, SingleRun(second), its);
    } else {
      test_single_run(probe, p, SingleRun(first), its);
    }
  }

  HWY_INLINE void test_single_run(const Probe& probe, std::uint32_t p, const SingleRun& run,
                                  ElementRuns& its) {
    if (run.size() > candidates) its.has_long_runs = true;
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
        count += probe.hits(run, k, probe.distance(run, k)) != 0 ? 1 : 0;
      }
      for (std::uint32_t n = 0; n < count; ++n) add_hits(probe, p, run, with_hits[n]);
    }
  }

  template <class Runs>
  HWY_INLINE void add_hits(const Probe& probe, std::uint32_t p, const Runs& runs, std::uint32_t k) {
    const auto distance = probe.distance(runs, k);
    const Bits hits = probe.hits(runs, k, distance) & lanes_before(runs.size() - k);
    hits_.add(layers_.number[p], p, runs, k, hits, probe.is_sure(runs, k, distance));
  }

  const Layers& layers_;
  SearchJob& job_;
  LayerHits hits_;
  Numbers band_;
  bool expects_care_ = false;
  bool expects_crowd_ = false;
  bool has_many_undecided_ = false;
};
