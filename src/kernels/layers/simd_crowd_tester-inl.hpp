// Elements of a crowd, which share blocks of candidates, included like simd_joined_runs-inl.hpp.

template <class Search>
class CrowdTester {
 public:
  using Elements = typename Search::Batch;

  HWY_INLINE CrowdTester(const LayerPair& layers, LayerHits& hits, CarefulTester<Search>& careful)
      : block_(layers), hits_(hits), careful_(careful) {}

  /// Tests the elements of a batch, the pairs of each one after the other.
  HWY_INLINE void test(const Elements& elements, BatchCounts<Search>& counts) {
    const std::uint32_t columns = columns_of_block(elements);
    for (std::uint32_t k = 0; k < elements.size();) {
      const std::uint32_t end = elements.end_of_columns(k, columns);
      if (HWY_LIKELY(block_.fill(runs_of(elements, k, end - 1)))) {
        test_block(elements, k, end, counts);
      } else {
        test_with_care(elements, k, end, counts);
      }
      k = end;
    }
  }

 private:
  using Probe = typename Search::Probe;

  /// Columns whose elements share a block: so many elements are worth a copy, and each column more
  /// brings candidates that are too far away for the others.
  [[nodiscard]] static HWY_INLINE std::uint32_t columns_of_block(const Elements& elements) {
    constexpr std::uint32_t elements_of_block = 8;
    constexpr std::uint32_t most_columns = Probe::is_right_beyond_runs ? 8 : 1;
    const std::uint32_t last = elements.size() - 1;
    const std::uint32_t columns = elements.column(last) - elements.column(0) + 1;
    return std::clamp(columns * elements_of_block / elements.size(), 1u, most_columns);
  }

  /// What the elements from the first to the last one meet, with these in front.
  [[nodiscard]] static HWY_INLINE std::array<Run, Search::runs> runs_of(const Elements& elements,
                                                                        std::uint32_t first,
                                                                        std::uint32_t last) {
    std::array<Run, Search::runs> all;
    const auto of_first = elements.runs_of(first);
    const auto of_last = elements.runs_of(last);
    const auto join = [&]<std::size_t... r>(std::index_sequence<r...>) HWY_ATTR {
      ((all[r] = {of_first.template run<r>().begin, of_last.template run<r>().end}), ...);
    };
    join(std::make_index_sequence<Search::runs>());
    all[0].begin = elements.place(first);
    return all;
  }

  HWY_INLINE void test_block(const Elements& elements, std::uint32_t first, std::uint32_t end,
                             BatchCounts<Search>& counts) {
    std::uint64_t tests = 0;
    for (std::uint32_t k = first; k < end;) {
      const std::uint32_t end_of_column = std::min(elements.end_of_columns(k, 1), end);
      tests += tests_of_column(elements, k, end_of_column - k, counts);
      k = end_of_column;
    }
    // A local copy, whose members stay in registers while hits are written.
    const LayerPair layers = block_.layers();
    const std::uint32_t size = block_.size();
    std::size_t found = hits_.found();
    for (std::uint32_t k = first; k < end; ++k) {
      if (HWY_LIKELY(test_element(layers, k - first, size, found))) continue;
      tests -= sizes_of(elements, k).total();
      found = test_undecided(elements, k, found, counts);
    }
    hits_.set_found(found);
    hits_.count_tests(tests);
  }

  /// Tests the element at that place of the block and adds to the hits that were found, unless the
  /// filter leaves a pair undecided.
  HWY_INLINE bool test_element(const LayerPair& layers, std::uint32_t own, std::uint32_t size,
                               std::size_t& found) {
    const Probe probe = Probe::at(layers, own);
    typename Probe::template Nearest<WidestLanes> nearest;
    found = hits_.make_room(found, size);
    std::uint32_t* const partners = hits_.partners();
    std::size_t end = found;
    const auto test = [&](const auto& vector) HWY_ATTR {
      end = LayerHits::write_partners(partners, layers.number, vector, probe.test(vector, nearest),
                                      end);
    };
    std::uint32_t k = own + 1;
    for (; k + WidestRun::capacity <= size; k += WidestRun::capacity) test(FullVector(k));
    test(WidestRun({k, size}));
    if (!nearest.is_decided(layers.band)) return false;
    hits_.template write_element<WidestLanes>(layers.number[own], found, end);
    found = end;
    return true;
  }

  HWY_NOINLINE std::size_t test_undecided(const Elements& elements, std::uint32_t k,
                                          std::size_t found, BatchCounts<Search>& counts) {
    hits_.set_found(found);
    counts.add(careful_.test_with_care(elements, k));
    return hits_.found();
  }

  /// The candidates of some elements in one column. Each has one less than the one before it, which
  /// is one of those of that.
  [[nodiscard]] static HWY_INLINE std::uint64_t tests_of_column(const Elements& elements,
                                                                std::uint32_t first,
                                                                std::uint32_t count,
                                                                BatchCounts<Search>& counts) {
    const VectorSizes sizes = sizes_of(elements, first);
    counts.add(sizes, count);
    const std::uint64_t n = count;
    return n * sizes.total() - n * (n - 1) / 2;
  }

  [[nodiscard]] static HWY_INLINE VectorSizes sizes_of(const Elements& elements, std::uint32_t k) {
    VectorSizes sizes;
    for_each_vector<Filling::single>(
        elements.runs_of(k), [&](const auto& run, auto v) HWY_ATTR { sizes.add(v, run.size()); });
    return sizes;
  }

  HWY_NOINLINE void test_with_care(const Elements& elements, std::uint32_t k, std::uint32_t end,
                                   BatchCounts<Search>& counts) {
    counts.crowded += end - k;
    counts.crowded_for_more += end - k;
    for (; k < end; ++k) counts.add(careful_.test_with_care(elements, k));
  }

  CrowdBlock block_;
  LayerHits& hits_;
  CarefulTester<Search>& careful_;
};
