// Elements that the vectors of their batch do not settle, included like simd_joined_runs-inl.hpp.

/// Tests one element at a time.
template <class Search>
class CarefulTester {
 public:
  using Layers = typename Search::Layers;
  using Elements = typename Search::Batch;

  HWY_INLINE CarefulTester(const Layers& layers, LayerHits& hits) : layers_(layers), hits_(hits) {}

  /// An element with more candidates than its vectors hold, if none is undecided and there are not
  /// very many. Otherwise this has no effect.
  HWY_NOINLINE bool test_crowded(const Elements& elements, std::uint32_t k, ElementRuns& its) {
    const auto runs = elements.runs_of(k);
    const std::uint32_t p = elements.place(k);
    using Pieces = RunPieces<Search::runs>;
    Pieces pieces;
    add_all(pieces, runs, std::make_index_sequence<Search::runs>());
    if (pieces.is_large()) return false;
    const Probe probe = Probe::at(layers_, p);
    typename Probe::template Nearest<WidestLanes> nearest;
    const std::size_t found = hits_.make_room(hits_.found(), Pieces::most * Pieces::capacity);
    std::size_t end = found;
    for (std::uint32_t n = 0; n < pieces.size(); ++n) {
      const WidestRun run = pieces[n];
      end = hits_.write_partners(layers_.number, run, probe.test(run, nearest), end);
    }
    if (!nearest.is_decided(layers_.band)) return false;
    hits_.write_element(layers_.number[p], found, end);
    hits_.set_found(end);
    hits_.count_tests(pieces.tests());
    its = {true, pieces.longest_run(), false};
    return true;
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

 private:
  using Probe = typename Search::Probe;

  /// Candidates of a run, more than which are those of a crowd.
  static constexpr auto long_run = 2 * static_cast<std::uint32_t>(lanes);

  template <class Runs, std::size_t... r>
  static HWY_INLINE void add_all(RunPieces<Search::runs>& pieces, const Runs& runs,
                                 std::index_sequence<r...>) {
    (pieces.add(runs.template run<r>()), ...);
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
    its.longest_run = std::max(its.longest_run, run.size());
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
  LayerHits& hits_;
};
