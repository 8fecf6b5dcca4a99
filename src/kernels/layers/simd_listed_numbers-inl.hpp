// Where the numbers of candidates come from once it is listed which elements have hits, included
// like simd_joined_runs-inl.hpp.

/// From the runs of these elements, which are loaded once more.
template <Filling filling>
class NumbersOfRuns {
 public:
  template <class Runs>
  HWY_INLINE void keep(const LayerPair&, const Runs&, std::uint32_t, std::uint32_t) {}

  /// Writes the hits of element k to that place of the buffer and returns where they end.
  template <class Elements>
  HWY_INLINE std::size_t write(const LayerPair& layers, const Elements& elements, std::uint32_t k,
                               HitBits hits, const LayerHits& to, std::size_t place) const {
    std::size_t end = place;
    for_each_vector<filling>(elements.runs_of(k), [&](const auto& runs, auto v) HWY_ATTR {
      const auto its_hits = static_cast<Bits>(hits >> (v * candidates));
      end = to.write_partners(layers.number, runs, its_hits, end);
    });
    to.write_element(layers.number[elements.place(k)], place, end);
    return end;
  }
};

/// From memory, where they were kept for all elements: most of them have hits, and vectors are so
/// short that loading runs takes longer.
template <Filling filling, std::size_t most_elements, std::size_t most_candidates>
class KeptNumbers {
 public:
  /// Keeps those of vector v of element k.
  template <class Runs>
  HWY_INLINE void keep(const LayerPair& layers, const Runs& runs, std::uint32_t k,
                       std::uint32_t v) {
    for (std::uint32_t lane = 0; lane < Runs::capacity; lane += Runs::at_once) {
      hn::StoreU(runs.load(Runs::numbers, layers.number, lane), Runs::numbers,
                 numbers_[k] + v * candidates + lane);
    }
  }

  template <class Elements>
  HWY_INLINE std::size_t write(const LayerPair& layers, const Elements& elements, std::uint32_t k,
                               HitBits hits, const LayerHits& to, std::size_t place) const {
    return to.write(layers.number[elements.place(k)], hits, numbers_[k], place);
  }

 private:
  std::uint32_t numbers_[most_elements][most_candidates];
};
