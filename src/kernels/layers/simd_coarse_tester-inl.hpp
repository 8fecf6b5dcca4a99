// Coarse elements and all of a layer in vectors, included like simd_joined_runs-inl.hpp.

/// Coarse elements are few, and their runs are long: each is tested run by run.
template <int Dim, class Probe>
class SimdCoarseTester {
 public:
  HWY_INLINE SimdCoarseTester(const ThreeLayers& layers, SearchJob& job)
      : layers_(layers), hits_(layers, job) {}

  HWY_INLINE void search(const FarSphere* coarse, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const Probe probe = Probe::of(layers_, coarse[k]);
      for_each_run_of_coarse<Dim>(
          layers_, coarse[k], [&](const Run& run) HWY_ATTR { test(probe, coarse[k].number, run); });
      hits_.take_now_and_then();
    }
    hits_.finish();
  }

 private:
  HWY_INLINE void test(const Probe& probe, std::uint32_t element, const Run& run) {
    hits_.count_tests(run.end - run.begin);
    for (std::uint32_t begin = run.begin; begin < run.end; begin += lanes) {
      const SingleRun candidates_of_one({begin, run.end});
      const Floats distance = probe.distance(candidates_of_one, 0);
      const Bits hits = probe.hits(candidates_of_one, 0, distance) & lanes_before(run.end - begin);
      if (hits == 0) continue;
      hits_.add(element, 0, candidates_of_one, 0, hits,
                probe.is_sure(candidates_of_one, 0, distance));
    }
  }

  const ThreeLayers& layers_;
  LayerHits hits_;
};
