// Elements that a search tests together, included like simd_joined_runs-inl.hpp.

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
      return {row_, place(k), column(k)};
    }

    [[nodiscard]] HWY_INLINE std::uint32_t column(std::uint32_t k) const {
      return layers_.column[place(k)];
    }

    /// The end of the elements from k on that stand in so many columns.
    [[nodiscard]] HWY_INLINE std::uint32_t end_of_columns(std::uint32_t k,
                                                          std::uint32_t columns) const {
      const std::uint32_t end = std::min(column(k) + columns, column(size() - 1) + 1);
      return std::min(row_.begin_of(end), elements_.end) - elements_.begin;
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
