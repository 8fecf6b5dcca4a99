// The reach of an element and its candidates as squares, included like simd_joined_runs-inl.hpp.

/// Spheres of one radius: the same bounds for all.
class CommonReach {
 public:
  HWY_INLINE CommonReach(const LayerPair& layers, std::uint32_t)
      : inner_(hn::Set(floats, layers.inner)), outer_(hn::Set(floats, layers.outer)) {}

  /// Square of the reach, less the slack, of the candidates from lane k on.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats inner(const Runs&, std::size_t) const {
    return inner_;
  }
  /// The same plus the slack.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats outer(const Runs&, std::size_t) const {
    return outer_;
  }

 private:
  Floats inner_;
  Floats outer_;
};

/// Spheres: the sum of the radii and the margin.
class SummedReach {
 public:
  HWY_INLINE SummedReach(const LayerPair& layers, std::uint32_t p)
      : radius_(layers.radius),
        nearest_(hn::Set(floats, layers.radius[p] + layers.nearest_margin)),
        farthest_(hn::Set(floats, layers.radius[p] + layers.farthest_margin)) {}

  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats inner(const Runs& runs, std::size_t k) const {
    const Floats sum = hn::Add(nearest_, runs.load(floats, radius_, k));
    const Floats nearest = hn::Max(sum, hn::Zero(floats));
    return hn::Mul(nearest, nearest);
  }
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats outer(const Runs& runs, std::size_t k) const {
    const Floats farthest = hn::Add(farthest_, runs.load(floats, radius_, k));
    return hn::Mul(farthest, farthest);
  }

 private:
  const float* radius_;
  Floats nearest_;
  Floats farthest_;
};
