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
      static constexpr std::size_t size = Row::size;

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
      : layers_(layers), job_(job), hits_(layers, job), careful_(layers, hits_) {}

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

  /// Tells whether all runs of most elements go into one vector, instead of two into each.
  static constexpr bool takes_all = fit_one_vector<Search::runs> && !Search::some_have_hits;
  /// The same of two vectors, where many elements have too many candidates for one.
  static constexpr bool takes_halves = takes_all && Search::runs == 5;

  /// Ways to test a batch: as suits most elements, or crowds, each way denser ones than the one
  /// before it.
  enum class Way { usual, in_halves, run_by_run, with_care };

  template <Filling filling>
  static constexpr std::size_t most_hits = vectors_of<filling, Search::runs>* candidates;
  template <class Lanes>
  using Nearest = typename Probe::template Nearest<Lanes>;

  /// One crowded element in so many costs more than vectors that are not joined.
  static constexpr std::uint32_t crowded_share = 5;

  /// In place of hits: the runs are too long for their vectors, or the filter leaves some
  /// undecided. An element of a crowd has the first bit alone.
  static constexpr HitBits with_care = HitBits{1} << 62;
  static constexpr HitBits with_undecided = HitBits{1} << 63;

  /// The elements of a batch by what they are like.
  struct BatchCounts {
    std::uint32_t crowded = 0;             ///< those that the usual vectors do not hold
    std::uint32_t crowded_for_halves = 0;  ///< those that two halves do not, where that is known
    std::uint32_t with_care = 0;           ///< those that vectors of single runs do not settle
    std::uint32_t undecided = 0;

    HWY_INLINE void add(const ElementRuns& its) {
      with_care += its.has_long_runs || its.has_undecided ? 1 : 0;
      undecided += its.has_undecided ? 1 : 0;
    }
  };

  HWY_INLINE void test_batch(const Elements& elements) {
    if (HWY_UNLIKELY(way_ != Way::usual)) return test_crowded_batch(elements);
    if constexpr (takes_all) {
      test_batch_of_all<AllRuns<Search::runs>>(elements);
    } else {
      test_batch_as<Filling::joined>(elements);
    }
  }

  HWY_NOINLINE void test_crowded_batch(const Elements& elements) {
    if (way_ == Way::with_care) return test_batch_with_care(elements);
    if constexpr (takes_halves) {
      if (way_ == Way::in_halves) return test_batch_of_all<FirstHalf, SecondHalf>(elements);
    }
    test_batch_as<Filling::single>(elements);
  }

  /// Writes hits as soon as all vectors of an element have been tested.
  template <class... Vectors>
  HWY_INLINE void test_batch_of_all(const Elements& elements) {
    BatchCounts counts;
    std::uint64_t tests = 0;
    std::size_t found = hits_.found();
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      const auto runs = elements.runs_of(k);
      found = test_all(elements, k, found, tests, counts, Vectors(runs)...);
    }
    hits_.count_tests(tests);
    hits_.set_found(found);
    expect(counts, elements);
  }

  /// An element whose runs are in these vectors. Returns how many hits there are then.
  template <class... Vectors>
  HWY_INLINE std::size_t test_all(const Elements& elements, std::uint32_t k, std::size_t found,
                                  std::uint64_t& tests, BatchCounts& counts,
                                  const Vectors&... vectors) {
    using Usual = AllRuns<Search::runs>;
    constexpr bool are_halves = sizeof...(Vectors) > 1;
    const std::uint32_t size = (vectors.size() + ...);
    if (are_halves) counts.crowded += size > Usual::capacity ? 1 : 0;
    if (HWY_UNLIKELY(!(vectors.fit() && ...))) {
      ++(are_halves ? counts.crowded_for_halves : counts.crowded);
      return test_apart(elements, k, found, counts);
    }
    const std::uint32_t p = elements.place(k);
    const Probe probe = Probe::at(layers_, p);
    Nearest<Usual> nearest;
    HitBits hits = 0;
    std::uint32_t first = 0;
    ((hits |= HitBits{probe.test(vectors, nearest)} << first, first += Vectors::capacity), ...);
    if (HWY_UNLIKELY(!nearest.is_decided(layers_.band))) {
      return test_undecided(elements, k, found, counts);
    }
    tests += size;
    const std::size_t begin = hits_.make_room(found, (Vectors::capacity + ...));
    std::size_t end = begin;
    ((end = hits_.write_partners(layers_.number, vectors, static_cast<Bits>(hits), end),
      hits >>= Vectors::capacity),
     ...);
    hits_.write_element(layers_.number[p], begin, end);
    return end;
  }

  template <Filling filling>
  HWY_INLINE void test_batch_as(const Elements& elements) {
    BatchCounts counts;
    if constexpr (Search::some_have_hits || lanes < candidates) {
      test_batch_by_list<filling>(elements, counts);
    } else {
      test_batch_at_once<filling>(elements, counts);
    }
    expect(counts, elements);
  }

  /// Writes the hits of a vector before it is known whether an element needs care: what is behind
  /// those found is overwritten.
  template <Filling filling>
  HWY_INLINE void test_batch_at_once(const Elements& elements, BatchCounts& counts) {
    std::uint64_t tests = 0;
    std::size_t found = hits_.found();
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      const std::uint32_t p = elements.place(k);
      const Probe probe = Probe::at(layers_, p);
      Nearest<EightLanes> nearest;
      VectorSizes sizes;
      found = hits_.make_room(found, most_hits<filling>);
      std::size_t end = found;
      for_each_vector<filling>(elements.runs_of(k), [&](const auto& runs, auto v) HWY_ATTR {
        sizes.add(v, runs.size());
        end = hits_.write_partners(layers_.number, runs, probe.test(runs, nearest), end);
      });
      count_crowded<filling>(sizes, counts);
      if (HWY_UNLIKELY(!sizes.fit())) {
        found = test_apart(elements, k, found, counts);
      } else if (HWY_UNLIKELY(!nearest.is_decided(layers_.band))) {
        found = test_undecided(elements, k, found, counts);
      } else {
        tests += sizes.total();
        hits_.write_element(layers_.number[p], found, end);
        found = end;
      }
    }
    hits_.count_tests(tests);
    hits_.set_found(found);
  }

  /// First lists the elements that have hits, which cannot be foreseen, without a branch; then
  /// writes these.
  template <Filling filling>
  HWY_INLINE void test_batch_by_list(const Elements& elements, BatchCounts& counts) {
    std::uint32_t number[batch_size][most_hits<filling>];
    HitBits hits[batch_size];
    std::uint32_t with_hits[batch_size + 1];
    std::uint32_t count = 0;
    std::uint64_t tests = 0;
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      hits[k] = filter<filling>(elements, k, number[k], tests, counts);
      with_hits[count] = k;
      count += hits[k] != 0 ? 1 : 0;
    }
    hits_.count_tests(tests);
    std::size_t found = hits_.found();
    for (std::uint32_t n = 0; n < count; ++n) {
      const std::uint32_t k = with_hits[n];
      if (HWY_UNLIKELY(hits[k] >= with_care)) {
        if (filling == Filling::joined && (hits[k] & with_care) != 0) ++counts.crowded;
        found = hits[k] >= with_undecided ? test_undecided(elements, k, found, counts)
                                          : test_apart(elements, k, found, counts);
        continue;
      }
      found = hits_.make_room(found, most_hits<filling>);
      found = hits_.write(layers_.number[elements.place(k)], hits[k], number[k], found);
    }
    hits_.set_found(found);
  }

  /// Returns the hits, or some number from `with_care` on; adds the tests that need no care.
  template <Filling filling>
  HWY_INLINE HitBits filter(const Elements& elements, std::uint32_t k, std::uint32_t* number,
                            std::uint64_t& tests, BatchCounts& counts) const {
    const Probe probe = Probe::at(layers_, elements.place(k));
    Nearest<EightLanes> nearest;
    VectorSizes sizes;
    HitBits hits = 0;
    for_each_vector<filling>(elements.runs_of(k), [&](const auto& runs, auto v) HWY_ATTR {
      sizes.add(v, runs.size());
      hits |= HitBits{probe.test(runs, nearest)} << (v * candidates);
      write_numbers(runs, number + v * candidates);
    });
    if (filling == Filling::single) count_crowded<filling>(sizes, counts);
    const auto has_too_many = static_cast<std::uint32_t>(!sizes.fit());
    const auto has_undecided = static_cast<std::uint32_t>(!nearest.is_decided(layers_.band));
    const std::uint32_t needs_care = has_too_many | has_undecided;
    tests += sizes.total() & (needs_care - 1);
    return hits | HitBits{has_too_many} * with_care | HitBits{has_undecided} * with_undecided;
  }

  template <class Runs>
  HWY_INLINE void write_numbers(const Runs& runs, std::uint32_t* number) const {
    for (std::uint32_t k = 0; k < Runs::capacity; k += Runs::at_once) {
      hn::StoreU(runs.load(Runs::numbers, layers_.number, k), Runs::numbers, number + k);
    }
  }

  /// Counts an element for which the usual vectors are too short, or would be.
  template <Filling filling>
  static HWY_INLINE void count_crowded(const VectorSizes& sizes, BatchCounts& counts) {
    if constexpr (takes_all) {
      counts.crowded += sizes.total() > AllRuns<Search::runs>::capacity ? 1 : 0;
      if (takes_halves) counts.crowded_for_halves += sizes.fit_halves() ? 0 : 1;
    } else {
      const bool fits = filling == Filling::joined ? sizes.fit() : sizes.fit_if_joined();
      counts.crowded += fits ? 0 : 1;
    }
  }

  /// Tests an element with more candidates than its vectors hold, or with an undecided one, and
  /// returns how many hits there are then.
  HWY_NOINLINE std::size_t test_apart(const Elements& elements, std::uint32_t k, std::size_t found,
                                      BatchCounts& counts) {
    hits_.set_found(found);
    counts.add(test_runs_of(elements, k));
    return hits_.found();
  }
  HWY_NOINLINE std::size_t test_undecided(const Elements& elements, std::uint32_t k,
                                          std::size_t found, BatchCounts& counts) {
    hits_.set_found(found);
    counts.add(careful_.test_with_care(elements, k));
    return hits_.found();
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
    way_ = way_after(counts, elements.size());
    has_many_undecided_ = 2 * counts.undecided > elements.size();
  }

  [[nodiscard]] static HWY_INLINE Way way_after(const BatchCounts& counts, std::uint32_t elements) {
    if (HWY_UNLIKELY(2 * counts.with_care > elements)) return Way::with_care;
    if (HWY_LIKELY(crowded_share * counts.crowded <= elements)) return Way::usual;
    const bool fit_halves = crowded_share * counts.crowded_for_halves <= elements;
    return takes_halves && fit_halves ? Way::in_halves : Way::run_by_run;
  }

  /// An element that the vectors of its batch do not settle.
  HWY_INLINE ElementRuns test_runs_of(const Elements& elements, std::uint32_t k) {
    ElementRuns its;
    if (!has_many_undecided_ && careful_.test_crowded(elements, k, its)) return its;
    return careful_.test_with_care(elements, k);
  }

  const Layers& layers_;
  SearchJob& job_;
  LayerHits hits_;
  CarefulTester<Search> careful_;
  Way way_ = Way::usual;
  bool has_many_undecided_ = false;
};
