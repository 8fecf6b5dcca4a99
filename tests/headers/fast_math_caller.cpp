// A program compiled and linked with -ffast-math, which flushes subnormal numbers to zero and takes
// no number for NaN in what is compiled with it. The library answers as always.

#include <abut/abut.hpp>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <vector>

#if !defined(__FAST_MATH__)
#error "this test is about -ffast-math"
#endif

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::exit(1);
}

/// Every struct that callers fill takes its members by name.
void set_by_name() {
  static_assert(std::is_aggregate_v<abut::Options> && std::is_aggregate_v<abut::PairRule> &&
                std::is_aggregate_v<abut::PairTraits> &&
                std::is_aggregate_v<abut::PairGeometrySpans> &&
                std::is_aggregate_v<abut::Column<double>>);
  const std::vector<std::uint32_t> groups{1, 1};
  const std::vector<double> x{0, 1};
  const abut::Column<double> column{.first = x.data(), .size = x.size()};
  const abut::PairRule rule{.elements = {.groups = groups}};
  const abut::ElementView view = abut::discs(column, column, 1.0);
  std::vector<double> gaps(1);
  abut::measure(view, abut::find_contact_pairs(view), {.gaps = gaps});
  require(gaps[0] < 0.0, "a gap of overlapping discs is not negative");
  require(abut::find_contact_pairs(view, abut::Domain::open(), {.rule = rule}).empty(),
          "elements of one group pair");
  require(abut::find_contact_pairs(view, abut::Domain::open(),
                                   {.algorithm = abut::Algorithm::rows,
                                    .order = abut::Order::as_found,
                                    .quantities = abut::Quantity::normal,
                                    .margin = 0.5,
                                    .max_pairs = 10,
                                    .threads = 1})
                  .normals()
                  .size() == 1,
          "options by name are not taken");
}

/// Touching and just not touching, where flushing to zero would make all touch.
void decide_on_subnormal_numbers() {
  const double least = std::bit_cast<double>(std::uint64_t{1});
  const std::vector<double> x{0.0, std::bit_cast<double>(std::uint64_t{2}),
                              std::bit_cast<double>(std::uint64_t{5})};
  const std::vector<double> y(3, 0.0);
  for (const abut::Algorithm algorithm :
       {abut::Algorithm::rows, abut::Algorithm::direct_check, abut::Algorithm::munjiza_nbs}) {
    const abut::PairList pairs = abut::find_contact_pairs(
        abut::discs(x, y, least), abut::Domain::open(), {.algorithm = algorithm});
    require(pairs.size() == 1 && pairs[0].first == 0 && pairs[0].second == 1,
            "subnormal numbers are decided otherwise");
  }
}

void refuse_what_is_no_number() {
  const std::vector<double> x{0.0, std::bit_cast<double>(std::uint64_t{0x7FF8} << 48U)};
  try {
    static_cast<void>(abut::find_contact_pairs(abut::discs(x, x, 1.0)));
  } catch (const abut::Error& error) {
    require(error.code() == abut::ErrorCode::invalid_input, "NaN ends in another error");
    return;
  }
  require(false, "NaN is taken for a number");
}

}  // namespace

int main() {
  set_by_name();
  decide_on_subnormal_numbers();
  refuse_what_is_no_number();
}
