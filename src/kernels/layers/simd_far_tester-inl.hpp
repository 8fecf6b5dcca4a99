// Elements that are not near and the smaller ones around them in vectors, included like
// simd_joined_runs-inl.hpp.

template <int Dim, class Probe>
class SimdFarTester {
 public:
  HWY_INLINE SimdFarTester(const ThreeLayers& layers, SearchJob& job)
      : layers_(layers), jobs_(layers, job) {}

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
    jobs_.finish();
  }

  /// Far elements in the own layer.
  HWY_INLINE void search(const FarSphere* far, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      for_each_run<Dim>(layers_, far[k], [&](const Run& run) {
        jobs_.make_room();
        jobs_.add(far[k], run);
      });
    }
    jobs_.finish();
  }

 private:
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
      jobs_.run();
      middle_count_ = 0;
    }
    FarSphere& element = middle_[middle_count_++];
    element = element_at(layers_, p);
    jobs_.make_room();
    for_each_run_around<Dim>(layers_, element, [&](const Run& run) { jobs_.add(element, run); });
  }

  const ThreeLayers& layers_;
  RunJobs<Dim, Probe> jobs_;
  std::size_t middle_count_ = 0;
  FarSphere middle_[most_middle];
};
