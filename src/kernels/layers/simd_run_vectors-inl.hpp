// The runs of an element in vectors, included like simd_joined_runs-inl.hpp.

/// How runs fill vectors: two in each, or where many elements have too many candidates for that,
/// each run its own.
enum class Filling { joined, single };

/// The hits among the candidates of an element: a bit for each lane of its vectors.
using HitBits = std::uint64_t;

template <Filling filling, std::size_t runs>
constexpr std::size_t vectors_of = filling == Filling::joined ? (runs + 1) / 2 : runs;

template <Filling filling, std::size_t v, class RunsOfElement>
[[nodiscard]] HWY_INLINE auto vector_of(const RunsOfElement& runs) {
  if constexpr (filling == Filling::single) {
    return SingleRun(runs.template run<v>());
  } else if constexpr (2 * v + 1 < RunsOfElement::size) {
    return JoinedRuns(runs.template run<2 * v>(), runs.template run<2 * v + 1>());
  } else {
    return SingleRun(runs.template run<2 * v>());
  }
}

/// Calls visit(runs, v) for each vector of an element's runs; its number v is a constant.
template <Filling filling, class RunsOfElement, class Visit>
HWY_INLINE void for_each_vector(const RunsOfElement& runs, const Visit& visit) {
  const auto visit_all = [&]<std::size_t... v>(std::index_sequence<v...>) HWY_ATTR {
    (visit(vector_of<filling, v>(runs), std::integral_constant<std::uint32_t, v>()), ...);
  };
  visit_all(std::make_index_sequence<vectors_of<filling, RunsOfElement::size>>());
}

/// How many candidates the vectors of an element are to hold.
class VectorSizes {
 public:
  /// Vector v, after those before it.
  HWY_INLINE void add(std::uint32_t v, std::uint32_t size) {
    total_ += size;
    excess_ |= size + (candidates - 1);
    if (v % 2 == 1) joined_excess_ |= last_ + size + (candidates - 1);
    last_ = size;
    half_ += size;
    if (v == 2 || v == 4) halves_excess_ |= std::exchange(half_, 0) + (2 * candidates - 1);
  }

  /// Candidates of all.
  [[nodiscard]] HWY_INLINE std::uint32_t total() const { return total_; }

  /// Tells whether each vector holds its candidates.
  [[nodiscard]] HWY_INLINE bool fit() const { return excess_ < 2 * candidates; }

  /// The same of single runs if two were joined in each.
  [[nodiscard]] HWY_INLINE bool fit_if_joined() const { return joined_excess_ < 2 * candidates; }

  /// The same if three and two of them shared a vector of twice as many.
  [[nodiscard]] HWY_INLINE bool fit_halves() const { return halves_excess_ < 4 * candidates; }

 private:
  std::uint32_t total_ = 0;
  std::uint32_t last_ = 0;
  std::uint32_t excess_ = 0;  ///< two vectors or more where one of them is to hold too many
  std::uint32_t joined_excess_ = 0;
  std::uint32_t half_ = 0;
  std::uint32_t halves_excess_ = 0;
};
