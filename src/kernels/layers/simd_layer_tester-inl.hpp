// The elements of a layer and their candidates in vectors, included like
// simd_joined_runs-inl.hpp.

template <class Search>
class SimdLayerTester {
 public:
  using Layers = typename Search::Layers;

  HWY_INLINE SimdLayerTester(const Layers& layers, SearchJob& job)
      : layers_(layers),
        job_(job),
        hits_(layers, job),
        careful_(layers, hits_),
        shares_all_(shares_all<Search>(job.wide_vectors)),
        has_few_hits_(job.has_few_hits) {
    if (!Search::some_have_hits) way_ = Way{job.way};
  }

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
    job_.has_few_hits = has_few_hits_;
    if (!Search::some_have_hits) job_.way = static_cast<std::uint8_t>(way_);
  }

 private:
  using Probe = typename Search::Probe;
  using Elements = typename Search::Batch;
  using Counts = BatchCounts<Search>;

  static constexpr std::uint32_t batch_size = 64;

  template <Filling filling>
  static constexpr std::size_t most_hits = vectors_of<filling, Search::runs>* candidates;
  template <class Lanes>
  using Nearest = typename Probe::template Nearest<Lanes>;

  /// In place of hits: the runs are too long for their vectors, or the filter leaves some
  /// undecided. An element of a crowd has the first bit alone.
  static constexpr HitBits with_care = HitBits{1} << 62;
  static constexpr HitBits with_undecided = HitBits{1} << 63;

  HWY_INLINE void test_batch(const Elements& elements) {
    if (HWY_UNLIKELY(way_ != Way::usual)) return test_crowded_batch(elements);
    if constexpr (takes_all<Search>) {
      if (shares_all_ && (!has_few_hits_ || was_crowded_)) {
        return test_batch_of_all<AllRuns<Search::runs>>(elements);
      }
    }
    test_batch_by_list<Filling::joined>(elements);
  }

  HWY_NOINLINE void test_crowded_batch(const Elements& elements) {
    if (way_ == Way::with_care) return test_batch_with_care(elements);
    if constexpr (!Search::some_have_hits) {
      if (way_ == Way::in_blocks) return test_batch_in_blocks(elements);
    }
    if constexpr (takes_halves<Search>) {
      if (shares_all_) return test_batch_of_all<FirstHalf, SecondHalf>(elements);
    }
    test_batch_by_list<Filling::single>(elements);
  }

  /// Writes hits as soon as all vectors of an element have been tested.
  template <class... Vectors>
  HWY_INLINE void test_batch_of_all(const Elements& elements) {
    Counts counts(shares_all_);
    std::uint64_t tests = 0;
    const std::size_t before = hits_.found();
    std::size_t found = before;
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      const auto runs = elements.runs_of(k);
      found = test_all(elements, k, found, tests, counts, Vectors(runs)...);
    }
    counts.hits = static_cast<std::uint32_t>(found - before);
    finish_batch(elements, tests, found, counts);
  }

  /// An element whose runs are in these vectors. Returns how many hits there are then.
  template <class... Vectors>
  HWY_INLINE std::size_t test_all(const Elements& elements, std::uint32_t k, std::size_t found,
                                  std::uint64_t& tests, Counts& counts, const Vectors&... vectors) {
    using Usual = AllRuns<Search::runs>;
    constexpr bool are_halves = sizeof...(Vectors) > 1;
    const std::uint32_t size = (vectors.size() + ...);
    if (are_halves) counts.crowded += size > Usual::capacity ? 1 : 0;
    if (HWY_UNLIKELY(!(vectors.fit() && ...))) {
      ++(are_halves ? counts.crowded_for_more : counts.crowded);
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
  HWY_INLINE void test_batch_by_list(const Elements& elements) {
    if constexpr (lanes < candidates && !Search::some_have_hits) {
      using Kept = KeptNumbers<filling, batch_size, most_hits<filling>>;
      if (!has_few_hits_) return test_batch_with_numbers<filling, Kept>(elements);
    }
    test_batch_with_numbers<filling, NumbersOfRuns<filling>>(elements);
  }

  /// First lists the elements that have hits, which cannot be foreseen, without a branch; then
  /// writes these.
  template <Filling filling, class NumbersOfList>
  HWY_NOINLINE void test_batch_with_numbers(const Elements& elements) {
    Counts counts(shares_all_);
    NumbersOfList kept;
    HitBits hits[batch_size];
    std::uint32_t with_hits[batch_size + 1];
    std::uint32_t count = 0;
    std::uint64_t tests = 0;
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      hits[k] = filter<filling>(elements, k, kept, tests, counts);
      with_hits[count] = k;
      count += hits[k] != 0 ? 1 : 0;
    }
    const std::size_t before = hits_.found();
    std::size_t found = before;
    for (std::uint32_t n = 0; n < count; ++n) {
      const std::uint32_t k = with_hits[n];
      if (HWY_UNLIKELY(hits[k] >= with_care)) {
        if (filling == Filling::joined && (hits[k] & with_care) != 0) ++counts.crowded;
        found = hits[k] >= with_undecided ? test_undecided(elements, k, found, counts)
                                          : test_apart(elements, k, found, counts);
        continue;
      }
      found = hits_.make_room(found, most_hits<filling>);
      found = kept.write(layers_, elements, k, hits[k], hits_, found);
    }
    counts.hits = static_cast<std::uint32_t>(found - before);
    finish_batch(elements, tests, found, counts);
  }

  /// Returns the hits, or some number from `with_care` on; adds the tests that need no care.
  template <Filling filling, class NumbersOfList>
  HWY_INLINE HitBits filter(const Elements& elements, std::uint32_t k, NumbersOfList& kept,
                            std::uint64_t& tests, Counts& counts) const {
    const Probe probe = Probe::at(layers_, elements.place(k));
    Nearest<EightLanes> nearest;
    VectorSizes sizes;
    HitBits hits = 0;
    for_each_vector<filling>(elements.runs_of(k), [&](const auto& runs, auto v) HWY_ATTR {
      sizes.add(v, runs.size());
      hits |= HitBits{probe.test(runs, nearest)} << (v * candidates);
      kept.keep(layers_, runs, k, v);
    });
    if (filling == Filling::single) count<filling>(sizes, counts);
    const auto has_too_many = static_cast<std::uint32_t>(!sizes.fit());
    const auto has_undecided = static_cast<std::uint32_t>(!nearest.is_decided(layers_.band));
    const std::uint32_t needs_care = has_too_many | has_undecided;
    tests += sizes.total() & (needs_care - 1);
    return hits | HitBits{has_too_many} * with_care | HitBits{has_undecided} * with_undecided;
  }

  /// Counts an element with vectors of these sizes.
  template <Filling filling>
  static HWY_INLINE void count(const VectorSizes& sizes, Counts& counts) {
    if constexpr (filling == Filling::single) {
      counts.add(sizes);
    } else {
      counts.crowded += sizes.fit() ? 0 : 1;
    }
  }

  /// Tests an element with more candidates than its vectors hold, or with an undecided one, and
  /// returns how many hits there are then.
  HWY_NOINLINE std::size_t test_apart(const Elements& elements, std::uint32_t k, std::size_t found,
                                      Counts& counts) {
    hits_.set_found(found);
    counts.add(test_runs_of(elements, k));
    return hits_.found();
  }
  HWY_NOINLINE std::size_t test_undecided(const Elements& elements, std::uint32_t k,
                                          std::size_t found, Counts& counts) {
    hits_.set_found(found);
    counts.add(careful_.test_with_care(elements, k));
    return hits_.found();
  }

  /// The elements of a batch most of which need care, as on a lattice or in a crowd.
  HWY_NOINLINE void test_batch_with_care(const Elements& elements) {
    Counts counts(shares_all_);
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      const ElementRuns its = test_runs_of(elements, k);
      counts.add(its);
      if (its.is_crowded) ++counts.crowded;
    }
    expect(counts, elements);
  }

  /// The elements of a batch most of which are in crowds.
  HWY_NOINLINE void test_batch_in_blocks(const Elements& elements) {
    Counts counts(shares_all_);
    CrowdTester<Search>(layers_, hits_, careful_).test(elements, counts);
    expect(counts, elements);
  }

  HWY_INLINE void finish_batch(const Elements& elements, std::uint64_t tests, std::size_t found,
                               const Counts& counts) {
    hits_.count_tests(tests);
    hits_.set_found(found);
    expect(counts, elements);
  }

  /// From most of a batch to the next one.
  HWY_INLINE void expect(const Counts& counts, const Elements& elements) {
    way_ = counts.next_way(elements.size());
    has_few_hits_ = counts.are_few_hits(elements.size());
    was_crowded_ |= way_ != Way::usual;
    has_many_undecided_ = 2 * counts.undecided > elements.size();
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
  const bool shares_all_;  ///< all runs of an element share a vector, or two
  Way way_ = Way::usual;
  bool has_many_undecided_ = false;
  bool has_few_hits_;
  bool was_crowded_ = false;  ///< some batch of the layer: two joined runs may often be too long
};
