// The hits of a search in layers, included like simd_joined_runs-inl.hpp.

class LayerHits {
 public:
  HWY_INLINE LayerHits(const LayerPair& layers, SearchJob& job)
      : layers_(layers), job_(job), hits_(*job.hits) {
    // Places are those of these layers: undecided pairs of others, or for others, are taken.
    if (layers_.copies != nullptr && hits_.undecided_count > 0) take();
    hits_.copies = layers_.copies;
  }

  /// What the search ends with.
  HWY_INLINE void finish() {
    if (layers_.copies != nullptr && hits_.undecided_count > 0) take();
    hits_.copies = nullptr;
    job_.candidate_tests += std::exchange(candidate_tests_, 0);
  }

  HWY_INLINE void count_tests(std::uint64_t tests) { candidate_tests_ += tests; }

  [[nodiscard]] HWY_INLINE std::size_t undecided_count() const { return hits_.undecided_count; }

  /// The end of the buffer as a local variable, which may stay in a register.
  [[nodiscard]] HWY_INLINE std::size_t found() const { return hits_.found; }
  HWY_INLINE void set_found(std::size_t found) { hits_.found = found; }

  /// Makes room for so many hits and returns where they may begin.
  HWY_INLINE std::size_t make_room(std::size_t found, std::size_t most) {
    if (HWY_LIKELY(found + most <= HitBuffer::size)) return found;
    hits_.found = found;
    take();
    return hits_.found;
  }

  /// Writes the partners of an element that hit, of one vector and with numbers of that column, to
  /// that place of the buffer and returns where they end. Whole vectors: the excess is overwritten.
  template <class Runs>
  HWY_INLINE std::size_t write_partners(const std::uint32_t* number, const Runs& runs, Bits hits,
                                        std::size_t place) const {
    return write_partners(hits_.partner, number, runs, hits, place);
  }

  /// The same, to the partners of the buffer as a local variable, which may stay in a register.
  [[nodiscard]] HWY_INLINE std::uint32_t* partners() const { return hits_.partner; }
  template <class Runs>
  static HWY_INLINE std::size_t write_partners(std::uint32_t* to, const std::uint32_t* number,
                                               const Runs& runs, Bits hits, std::size_t place) {
    for (std::uint32_t k = 0; k < Runs::capacity; k += Runs::at_once) {
      place = write_set<Runs>(to, runs.load(Runs::numbers, number, k), hits >> k, place);
    }
    return place;
  }

  /// The same of an element with its partners, of candidates whose numbers are in memory.
  template <std::size_t most>
  HWY_INLINE std::size_t write(std::uint32_t element, HitBits hits,
                               const std::uint32_t (&number)[most], std::size_t place) const {
    std::size_t end = place;
    for (std::size_t k = 0; k < most; k += lanes) {
      end = write_set<EightLanes>(hits_.partner, hn::LoadU(numbers, number + k),
                                  static_cast<Bits>(hits >> k), end);
    }
    write_element(element, place, end);
    return end;
  }

  /// The same of the element alone, whose partners are there.
  template <class Lanes = EightLanes>
  HWY_INLINE void write_element(std::uint32_t element, std::size_t place, std::size_t end) const {
    const auto own = hn::Set(Lanes::numbers, element);
    do {
      hn::StoreU(own, Lanes::numbers, hits_.element + place);
      place += Lanes::at_once;
    } while (place < end);
  }

  /// Adds the hits among the candidates in the lanes from k on, with notes of those that are not
  /// sure. p is the element's place.
  template <class Runs>
  HWY_INLINE void add(std::uint32_t element, std::uint32_t p, const Runs& runs, std::uint32_t k,
                      Bits hits, Mask is_sure) {
    if (HWY_UNLIKELY(hits_.found + lanes > HitBuffer::size)) take();
    note_undecided(hits, hn::VecFromMask(numbers, hn::RebindMask(numbers, hn::Not(is_sure))), p,
                   runs.places(k));
    hn::StoreU(hn::Set(numbers, element), numbers, hits_.element + hits_.found);
    hn::StoreU(compress(runs.load(numbers, layers_.number, k), hits), numbers,
               hits_.partner + hits_.found);
    hits_.found += static_cast<std::size_t>(std::popcount(hits));
  }

  HWY_INLINE void take_now_and_then() {
    if (HWY_UNLIKELY(candidate_tests_ >= tests_between_takes)) take();
  }

  HWY_NOINLINE void take() {
    job_.candidate_tests += std::exchange(candidate_tests_, 0);
    job_.take(job_);
  }

 private:
  /// Writes the numbers of the first lanes of the set, of which there may be more.
  template <class Lanes>
  static HWY_INLINE std::size_t write_set(std::uint32_t* to,
                                          hn::Vec<typename Lanes::NumberTag> partners, Bits set,
                                          std::size_t place) {
    set &= (Bits{1} << Lanes::at_once) - 1;
    hn::StoreU(Lanes::compress(partners, set), Lanes::numbers, to + place);
    return place + static_cast<std::size_t>(std::popcount(set));
  }

  /// Notes the places of the undecided ones among the hits that are about to be written. Without a
  /// branch: the excess is overwritten.
  HWY_INLINE void note_undecided(Bits hits, Numbers is_undecided, std::uint32_t p,
                                 Numbers partners) {
    const Bits written = (1u << std::popcount(hits)) - 1;
    const auto in_order = hn::Ne(compress(is_undecided, hits), hn::Zero(numbers));
    const Bits undecided = bits_of(hn::RebindMask(floats, in_order)) & written;
    const std::size_t count = hits_.undecided_count;
    const Numbers place = numbers_from(static_cast<std::uint32_t>(hits_.found));
    hn::StoreU(compress(place, undecided), numbers, hits_.undecided + count);
    if (layers_.copies != nullptr) {
      hn::StoreU(hn::Set(numbers, p), numbers, hits_.element_place + count);
      hn::StoreU(compress(compress(partners, hits), undecided), numbers,
                 hits_.partner_place + count);
    }
    hits_.undecided_count += static_cast<std::size_t>(std::popcount(undecided));
  }

  const LayerPair& layers_;
  SearchJob& job_;
  HitBuffer& hits_;
  std::uint64_t candidate_tests_ = 0;
};
