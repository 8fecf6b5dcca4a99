// Elements that are not near and the smaller ones around them in vectors, included like
// simd_joined_runs-inl.hpp.

template <int Dim>
class SimdFarTester {
 public:
  HWY_INLINE SimdFarTester(const ThreeLayers& layers, SearchJob& job)
      : layers_(layers), hits_(layers, job) {}

  /// The middle elements of the own layer, in all three layers.
  HWY_INLINE void search_middle() {
    for (std::uint32_t row = 1; row <= layers_.rows; ++row) {
      const Run elements = ElementsOfRow(layers_, row).elements();
      for (std::uint32_t p = elements.begin; p < elements.end; p += lanes) {
        Bits middle = middle_from(p) & lanes_before(elements.end - p);
        for (; middle != 0; middle &= middle - 1) {
          look_around(p + static_cast<std::uint32_t>(std::countr_zero(middle)));
        }
      }
    }
    finish();
  }

  /// Far elements in the own layer.
  HWY_INLINE void search(const FarSphere* far, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      for_each_run<Dim>(layers_, far[k], [&](const Run& run) { add(far[k], run); });
    }
    finish();
  }

 private:
  using Probe = LayerProbe<Dim, SmallerReach>;

  /// A vector of candidates, or less, that an element is to meet.
  struct RunJob {
    const FarSphere* element;
    std::uint32_t begin;
    std::uint32_t size;
  };
  static constexpr auto vector_size = static_cast<std::uint32_t>(lanes);
  static constexpr std::uint32_t most_jobs = 256;
  static constexpr std::size_t most_middle = 32;

  [[nodiscard]] HWY_INLINE Bits middle_from(std::uint32_t p) const {
    const Floats radius = hn::LoadU(floats, layers_.radius + p);
    const Floats reach = hn::Add(hn::Add(radius, radius), hn::Set(floats, layers_.margin + 8.0f));
    const auto is_middle = hn::And(hn::Ge(reach, hn::Set(floats, near_reach)),
                                   hn::Lt(reach, hn::Set(floats, middle_reach)));
    return bits_of(is_middle);
  }

  HWY_INLINE void look_around(std::uint32_t p) {
    if (HWY_UNLIKELY(middle_count_ == most_middle)) {
      run_jobs();
      middle_count_ = 0;
    }
    FarSphere& element = middle_[middle_count_++];
    element = element_at(layers_, p);
    for_each_run_around<Dim>(layers_, element, [&](const Run& run) { add(element, run); });
  }

  /// Most runs are no longer than two vectors. Empty ones are overwritten, without a branch.
  HWY_INLINE void add(const FarSphere& element, Run run) {
    hits_.count_tests(run.end - run.begin);
    while (HWY_UNLIKELY(run.end - run.begin > 2 * vector_size)) {
      jobs_[job_count_++] = {&element, run.begin, vector_size};
      run.begin += vector_size;
      run_jobs_if_full();
    }
    const std::uint32_t size = run.end - run.begin;
    jobs_[job_count_] = {&element, run.begin, std::min(size, vector_size)};
    job_count_ += size > 0 ? 1 : 0;
    jobs_[job_count_] = {&element, run.begin + vector_size, size - vector_size};
    job_count_ += size > vector_size ? 1 : 0;
    run_jobs_if_full();
  }

  HWY_INLINE void run_jobs_if_full() {
    if (HWY_UNLIKELY(job_count_ > most_jobs - 2)) run_jobs();
  }

  /// First which jobs have hits, then the hits: two loops whose branches can be foreseen.
  HWY_NOINLINE void run_jobs() {
    std::uint32_t with_hits[most_jobs + 1];
    std::uint32_t count = 0;
    for (std::uint32_t k = 0; k < job_count_; ++k) {
      with_hits[count] = k;
      count += test(jobs_[k]) != 0 ? 1 : 0;
    }
    for (std::uint32_t k = 0; k < count; ++k) add_hits(jobs_[with_hits[k]]);
    job_count_ = 0;
    hits_.take_now_and_then();
  }

  HWY_INLINE void finish() {
    run_jobs();
    hits_.finish();
  }

  [[nodiscard]] HWY_INLINE Bits test(const RunJob& job) const {
    const SingleRun run({job.begin, job.begin + job.size});
    const Probe probe = probe_of(job);
    return hits_of(probe, run, probe.distance_squared(run, 0));
  }

  HWY_INLINE void add_hits(const RunJob& job) {
    const SingleRun run({job.begin, job.begin + job.size});
    const Probe probe = probe_of(job);
    const Floats squares = probe.distance_squared(run, 0);
    hits_.add(job.element->number, 0, run, 0, hits_of(probe, run, squares),
              probe.is_sure(run, 0, squares));
  }

  [[nodiscard]] HWY_INLINE Probe probe_of(const RunJob& job) const {
    return {layers_, job.element->position, SmallerReach(layers_, *job.element)};
  }

  [[nodiscard]] static HWY_INLINE Bits hits_of(const Probe& probe, const SingleRun& run,
                                               Floats squares) {
    return probe.hits(run, 0, squares) & lanes_before(run.size());
  }

  const ThreeLayers& layers_;
  LayerHits hits_;
  std::uint32_t job_count_ = 0;
  std::size_t middle_count_ = 0;
  FarSphere middle_[most_middle];
  RunJob jobs_[most_jobs];
};
