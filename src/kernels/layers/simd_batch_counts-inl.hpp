// What a batch of elements was like, from which follows how the next one is tested, included like
// simd_joined_runs-inl.hpp.

/// Ways to test a batch: as suits most elements, or crowds, each way denser ones than the one
/// before it.
enum class Way : std::uint8_t { usual, for_more, in_blocks, with_care };

/// Tells whether all runs of most elements may go into one vector, instead of two into each.
template <class Search>
constexpr bool takes_all = fit_one_vector<Search::runs> && !Search::some_have_hits;
/// The same of two vectors, where many elements have too many candidates for one. Otherwise each
/// run has its own.
template <class Search>
constexpr bool takes_halves = Search::runs == 5 && takes_all<Search>;

/// Tells whether they do on this processor: wide vectors must be computed at once.
template <class Search>
[[nodiscard]] HWY_INLINE bool shares_all(WideVectors wide) {
  return takes_all<Search> && (!takes_halves<Search> || wide == WideVectors::whole);
}

/// Runs of an element that was tested by itself.
struct ElementRuns {
  bool is_crowded = false;        ///< two joined runs are too long for a vector
  std::uint32_t longest_run = 0;  ///< candidates of the longest one that was not joined
  bool has_undecided = false;
};

/// The elements of a batch by what they are like.
template <class Search>
struct BatchCounts {
  HWY_INLINE explicit BatchCounts(bool shares) : shares_vectors(shares) {}

  bool shares_vectors;                 ///< whether all runs of an element share one, or two
  std::uint32_t crowded = 0;           ///< those that the usual vectors do not hold
  std::uint32_t crowded_for_more = 0;  ///< those that vectors for more do not, where that is known
  std::uint32_t with_care = 0;         ///< those that no way but the last one settles
  std::uint32_t undecided = 0;
  std::uint32_t hits = 0;  ///< where they were taken meanwhile, more than there may be

  HWY_INLINE void add(const ElementRuns& its) {
    with_care += its.longest_run > longest_run || its.has_undecided ? 1 : 0;
    undecided += its.has_undecided ? 1 : 0;
  }

  /// Adds so many elements with single runs of these sizes.
  HWY_INLINE void add(const VectorSizes& singles, std::uint32_t elements = 1) {
    const bool is_usual = shares_vectors ? singles.total() <= AllRuns<Search::runs>::capacity
                                         : singles.fit_if_joined();
    const bool fits_more =
        takes_halves<Search> && shares_vectors ? singles.fit_halves() : singles.fit();
    crowded += is_usual ? 0 : elements;
    crowded_for_more += fits_more ? 0 : elements;
  }

  /// Tells whether so many elements have so few hits that those of the next ones that have some
  /// are listed.
  [[nodiscard]] HWY_INLINE bool are_few_hits(std::uint32_t elements) const {
    return few_hits_share * hits < elements;
  }

  /// The way that suits most of so many elements.
  [[nodiscard]] HWY_INLINE Way next_way(std::uint32_t elements) const {
    if (HWY_UNLIKELY(2 * with_care > elements)) return Way::with_care;
    if (HWY_LIKELY(crowded_share * crowded <= elements)) return Way::usual;
    const bool fit_more = crowded_share * crowded_for_more <= elements;
    return fit_more || Search::some_have_hits ? Way::for_more : Way::in_blocks;
  }

 private:
  /// One crowded element in so many costs more than the next denser way.
  static constexpr std::uint32_t crowded_share = 5;

  /// Hits of one element in so many are worth a list: where runs are few, less is saved.
  static constexpr std::uint32_t few_hits_share = Search::runs == 2 ? 4 : 1;

  /// Longer ones fit into no block, or where there is none, into no vector.
  static constexpr std::uint32_t longest_run =
      Search::some_have_hits ? candidates : CrowdBlock::most / Search::runs;
};
