// Runs that single elements are to meet, worked off many at a time, included like
// simd_joined_runs-inl.hpp.

/// A vector of candidates, or less, that an element is to meet: those of its lanes that are before
/// `size`, which may be more than there are lanes.
struct RunJob {
  const FarSphere* element;
  std::uint32_t begin;
  std::uint32_t size;
};

/// How many vectors a run takes could not be foreseen, nor which of them have hits. So runs are cut
/// into jobs without a branch, and all jobs are looked at before the hits of any are written.
template <int Dim, class Probe>
class RunJobs {
 public:
  HWY_INLINE RunJobs(const ThreeLayers& layers, SearchJob& job)
      : layers_(layers), hits_(layers, job) {}

  /// Makes room for the jobs of as many short runs as a middle element may have.
  HWY_INLINE void make_room() {
    static_assert(most_runs_around<Dim> * jobs_of_run <= most_jobs);
    if (HWY_UNLIKELY(count_ + most_runs_around<Dim> * jobs_of_run > most_jobs)) run();
  }

  /// Adds the jobs of a short run, for which there must be room. Before those of the end of a
  /// longer one, it makes room for as many as `make_room` does.
  HWY_INLINE void add(const FarSphere& element, Run run) {
    hits_.count_tests(run.end - run.begin);
    if (HWY_UNLIKELY(run.end - run.begin > short_run)) add_begin_of_long(element, run);
    const std::uint32_t size = run.end - run.begin;
    std::uint32_t count = count_;
    for (std::uint32_t k = 0; k < short_run; k += vector_size) {
      // One that is not needed is overwritten.
      jobs_[count] = {&element, run.begin + k, size - k};
      count += size > k ? 1 : 0;
    }
    count_ = count;
  }

  /// Runs the jobs that were added, after which their elements may be forgotten.
  HWY_NOINLINE void run() {
    std::uint32_t with_hits[most_jobs + 1];
    std::uint32_t count = 0;
    for (std::uint32_t k = 0; k < count_; ++k) {
      with_hits[count] = k;
      count += test(jobs_[k]) != 0 ? 1 : 0;
    }
    for (std::uint32_t k = 0; k < count; ++k) add_hits(jobs_[with_hits[k]]);
    count_ = 0;
    hits_.take_now_and_then();
  }

  HWY_INLINE void finish() {
    run();
    hits_.finish();
  }

 private:
  /// Most runs have no more candidates.
  static constexpr std::uint32_t short_run = 16;
  static constexpr auto vector_size = static_cast<std::uint32_t>(lanes);
  static constexpr std::uint32_t jobs_of_run = short_run / vector_size;
  static constexpr std::uint32_t most_jobs = 256;

  /// Leaves the end of the run, a short one.
  HWY_NOINLINE void add_begin_of_long(const FarSphere& element, Run& run) {
    for (; run.end - run.begin > short_run; run.begin += vector_size) {
      jobs_[count_++] = {&element, run.begin, vector_size};
      make_room();
    }
  }

  [[nodiscard]] HWY_INLINE Bits test(const RunJob& job) const {
    const SingleRun run({job.begin, job.begin + job.size});
    const Probe probe = Probe::of(layers_, *job.element);
    return hits_of(probe, run, probe.distance(run, 0));
  }

  HWY_INLINE void add_hits(const RunJob& job) {
    const SingleRun run({job.begin, job.begin + job.size});
    const Probe probe = Probe::of(layers_, *job.element);
    const Floats distance = probe.distance(run, 0);
    hits_.add(job.element->number, 0, run, 0, hits_of(probe, run, distance),
              probe.is_sure(run, 0, distance));
  }

  /// Lanes beyond those of a vector have no bits in the hits: no branch for what is a full one.
  [[nodiscard]] static HWY_INLINE Bits hits_of(const Probe& probe, const SingleRun& run,
                                               Floats distance) {
    static_assert(short_run < 32);
    return probe.hits(run, 0, distance) & ((Bits{1} << run.size()) - 1);
  }

  const ThreeLayers& layers_;
  LayerHits hits_;
  std::uint32_t count_ = 0;
  RunJob jobs_[most_jobs + jobs_of_run];
};
