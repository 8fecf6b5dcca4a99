// What can go wrong, and how to stop a detection that takes too long.
#include <abut/abut.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

/// Runs a detection that is expected to fail and prints the one sentence it fails with.
void expect_error(const abut::ElementView& elements, const abut::Options& options) {
  try {
    const abut::PairList pairs = abut::find_contact_pairs(elements, abut::Domain::open(), options);
    std::printf("%zu pairs\n", pairs.pairs().size());
  } catch (const abut::Error& error) {
    // The value of the code is also the exit code of the command-line tool.
    std::printf("error %d: %s\n", static_cast<int>(error.code()), error.what());
  }
}

}  // namespace

int main() {
  std::vector<double> x(2000), y(2000, 0.0);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = static_cast<double>(k);
  const abut::ElementView chain = abut::discs(x, y, 0.5);  // sees later changes of x and y

  // A limit on the result: nothing is returned rather than a part of it.
  abut::Options limited;
  limited.max_pairs = 1000;
  expect_error(chain, limited);

  // An algorithm whose memory follows the domain says so before it allocates.
  abut::Options screening;
  screening.algorithm = abut::Algorithm::screening_array;
  screening.max_bytes = 100'000;
  y[7] = 50.0;
  expect_error(chain, screening);

  // The hook is called every few thousand elements from this thread; it may stop the detection.
  abut::Options patient;
  patient.progress = [](const abut::Progress& now) {
    return now.phase == "search" ? abut::ProgressAction::cancel : abut::ProgressAction::proceed;
  };
  expect_error(chain, patient);

  // Numbers that are no numbers are named, never dropped.
  y[42] = std::nan("");
  expect_error(chain, {});
}
