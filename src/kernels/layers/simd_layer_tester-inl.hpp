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
    if constexpr (takes_all) {
      test_batch_of_all(elements);
    } else {
      test_batch_as<Filling::joined>(elements);
    }
  }

  HWY_NOINLINE void test_crowded_batch(const Elements& elements) {
    test_batch_as<Filling::single>(elements);
  }

  /// An element's runs in one vector, whose hits are written as soon as they are known.
  HWY_INLINE void test_batch_of_all(const Elements& elements) {
    using All = AllRuns<Search::runs>;
    BatchCounts counts;
    std::uint64_t tests = 0;
    std::size_t found = hits_.found();
    for (std::uint32_t k = 0; k < elements.size(); ++k) {
      const All runs(elements.runs_of(k));
      if (HWY_UNLIKELY(!runs.fit())) {
        ++counts.crowded;
        found = test_apart(elements, k, found, counts);
        continue;
      }
      const std::uint32_t p = elements.place(k);
      const Probe probe = Probe::at(layers_, p);
      Nearest<All> nearest;
      const Bits hits = probe.test(runs, nearest);
      if (HWY_UNLIKELY(!nearest.is_decided(layers_.band))) {
        found = test_undecided(elements, k, found, counts);
        continue;
      }
      tests += runs.size();
      found = hits_.make_room(found, runs.capacity);
      const std::size_t end = hits_.write_partners(layers_.number, runs, hits, found);
      hits_.write_element(layers_.number[p], found, end);
      found = end;
    }
    hits_.count_tests(tests);
    hits_.set_found(found);
    expect(counts, elements);
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
      if (is_crowded<filling>(sizes)) ++counts.crowded;
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
    if (filling == Filling::single) counts.crowded += is_crowded<filling>(sizes) ? 1 : 0;
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

  /// Tells whether the usual vectors would not hold the candidates of an element.
  template <Filling filling>
  [[nodiscard]] static HWY_INLINE bool is_crowded(const VectorSizes& sizes) {
    if constexpr (takes_all) return sizes.total() > AllRuns<Search::runs>::capacity;
    return filling == Filling::joined ? !sizes.fit() : !sizes.fit_if_joined();
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
    expects_care_ = 2 * counts.with_care > elements.size();
    expects_crowd_ = crowded_share * counts.crowded > elements.size();
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
  bool expects_care_ = false;
  bool expects_crowd_ = false;
  bool has_many_undecided_ = false;
};
