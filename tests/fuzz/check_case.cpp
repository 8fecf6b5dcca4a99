#include "fuzz/check_case.hpp"

#include "fuzz/check_candidates.hpp"
#include "fuzz/check_device.hpp"
#include "fuzz/check_face.hpp"
#include "fuzz/check_geometry.hpp"

#include <abut/error.hpp>
#include <abut/simd.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace abut::fuzz {
namespace {

/// Heads of cells follow the extent; more of them would only take time.
constexpr std::uint64_t most_bytes_of_grids = 1U << 18;

bool follows_extent(Algorithm algorithm) {
  return algorithm == Algorithm::binary_tree || algorithm == Algorithm::screening_array ||
         algorithm == Algorithm::munjiza_nbs;
}

std::vector<Simd> levels() {
  std::vector<Simd> result;
  for (const Simd level : simd_levels()) {
    if (available(level)) result.push_back(level);
  }
  return result;
}

/// What a call threw, if it did.
struct Refusal {
  std::optional<ErrorCode> code;
  std::string sentence;

  friend bool operator==(const Refusal& a, const Refusal& b) { return a.code == b.code; }
};

std::string written(const Refusal& refusal) {
  if (!refusal.code) return "no error";
  return "error " + std::to_string(static_cast<int>(*refusal.code)) + " (" + refusal.sentence + ")";
}

Refusal refusal_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  return {};
}

std::string named(const char* what, Face face, const Options& options) {
  return std::string(what) + " " + std::string(name_of(options.algorithm)) + ", " + name_of(face) +
         ", " + std::string(name_of(options.simd)) + ", " + std::to_string(options.threads) +
         " threads: ";
}

/// One state of a case with all that is asked about it.
class StateChecker {
 public:
  StateChecker(const Question& question, const Plan& plan) : question_(question), plan_(plan) {
    Options options = question.options();
    options.algorithm = Algorithm::direct_check;
    options.threads = 1;
    refusal_ = refusal_of([&] { check_free(Face::canonical_list, options); });
    const Expected& expected = question.expected();
    if (expected.must_refuse && !refusal_.code)
      throw Failure("a shift beyond 32 bits is not refused");
    const bool may_refuse = refusal_.code == ErrorCode::invalid_input && expected.may_refuse;
    if (refusal_.code && !may_refuse) {
      throw Failure("direct_check refuses: " + written(refusal_));
    }
  }

  void check_sampled() const {
    std::size_t k = 0;
    for (const AlgorithmInfo& row : algorithms()) check_chosen(row.algorithm, k++);
    check_chosen(Algorithm::automatic, k);
    if (!refusal_.code) check_geometry(question_);
  }

  void check_completely() const {
    for (const AlgorithmInfo& row : algorithms()) {
      for (const Face face : all_faces) {
        for (const Options& options : all_options(row.algorithm)) ask(face, options);
      }
    }
    if (!refusal_.code) check_geometry(question_);
  }

  void check_detector(Detector& detector, Face face, Options options) const {
    const Refusal refusal = refusal_of([&] {
      check_face(face, AskedDetector{question_, options, detector});
    });
    if (refusal == refusal_) return;
    throw Failure("the Detector has " + written(refusal) + ", direct_check " + written(refusal_));
  }

  void check_device(DeviceChecker& device, std::size_t step) const {
    const Refusal refusal = refusal_of([&] { device.check(question_, step); });
    if (refusal == refusal_) return;
    throw Failure("the stages of devices have " + written(refusal) + ", direct_check " +
                  written(refusal_));
  }

  [[nodiscard]] Options chosen_options(Algorithm algorithm, std::size_t k) const {
    static const std::vector<Simd> available_levels = levels();
    const unsigned choice = plan_.choices[k % plan_.choices.size()];
    Options options = question_.options();
    options.algorithm = algorithm;
    // Few elements are hardly ever worth several threads, and those take time.
    const unsigned threads = choice / 9 % 8;
    options.threads = threads < 6 ? 1 : static_cast<int>(threads) - 4;
    options.simd = available_levels[choice / 63 % available_levels.size()];
    options.shifts = choice % 2 == 0 ? Shifts::stored : Shifts::none;
    options.quantities = measured(plan_.quantities);
    if (follows_extent(algorithm)) options.max_bytes = most_bytes_of_grids;
    return options;
  }

  [[nodiscard]] Face chosen_face(std::size_t k) const {
    return all_faces[plan_.choices[k % plan_.choices.size()] % all_faces.size()];
  }

 private:
  /// Distances and vectors are those of centers, which boxes do not have.
  [[nodiscard]] Quantities measured(Quantities data) const {
    return question_.system().first.shape == Shape::sphere ? data : Quantities();
  }

  [[nodiscard]] std::vector<Options> all_options(Algorithm algorithm) const {
    Options options = chosen_options(algorithm, 0);
    options.shifts = Shifts::stored;
    options.quantities = measured(Quantity::distance | Quantity::vector);
    if (algorithm != Algorithm::rows) {
      options.threads = 1;
      return {options};
    }
    std::vector<Options> result;
    for (const Simd level : levels()) {
      options.simd = level;
      options.threads = 1;
      result.push_back(options);
    }
    for (const int threads : {2, 3}) {
      options.threads = threads;
      result.push_back(options);
    }
    return result;
  }

  void check_chosen(Algorithm algorithm, std::size_t k) const {
    ask(chosen_face(k), chosen_options(algorithm, k));
  }

  void check_free(Face face, const Options& options) const {
    try {
      check_face(face, FreeFunctions{question_, options});
    } catch (const Failure& failure) {
      throw Failure(named("", face, options) + failure.what());
    }
  }

  /// What one algorithm refuses, all do, but for what the pages say: grids that take too much
  /// memory, and algorithms of open space in a periodic domain.
  void ask(Face face, const Options& options) const {
    const Refusal refusal = refusal_of([&] { check_free(face, options); });
    if (refusal == refusal_) return;
    const bool open_only = options.algorithm != Algorithm::automatic &&
                           !info(options.algorithm).periodic && question_.domain().is_periodic();
    if (open_only && refusal.code == ErrorCode::wrong_usage) return;
    if (follows_extent(options.algorithm) && refusal.code == ErrorCode::limit_exceeded) return;
    throw Failure(named("", face, options) + written(refusal) + ", direct_check has " +
                  written(refusal_));
  }

  const Question& question_;
  const Plan& plan_;
  Refusal refusal_;
};

/// Goes through all states with one Detector.
class DetectorChecker {
 public:
  explicit DetectorChecker(const Case& given) : plan_(given.plan) {
    detector_.set_skin(given.plan.skin);
  }

  void check(const StateChecker& state, const System& system, std::size_t step) {
    if (!system.second && plan_.choices[7] % 2 == 0) {
      detector_.set_ids(system.ids);
    } else {
      detector_.set_ids({});
    }
    const Algorithm algorithm =
        plan_.choices[6] % 4 == 0 ? Algorithm::direct_check : Algorithm::automatic;
    for (const std::size_t k : {step, step + 4}) {
      const Face face = state.chosen_face(k);
      try {
        state.check_detector(detector_, face, state.chosen_options(algorithm, k));
      } catch (const Failure& failure) {
        throw Failure("state " + std::to_string(step) + ", Detector, " + name_of(face) + ": " +
                      failure.what());
      }
    }
  }

 private:
  const Plan& plan_;
  Detector detector_;
};

/// By direct checking, which few elements have shown to be right; none where there are too many
/// pairs. What it refuses, all must refuse.
std::optional<Expected> by_direct_check(const System& system) {
  constexpr PairCount most_pairs = 200'000;
  Expected expected;
  expected.may_refuse = true;
  const Question question(system, expected);
  Options options = question.options();
  options.algorithm = Algorithm::direct_check;
  options.shifts = Shifts::stored;
  options.max_pairs = most_pairs;
  try {
    const PairList list = FreeFunctions{question, options}.list();
    for (std::size_t k = 0; k < list.size(); ++k) {
      expected.pairs.push_back({list[k], list.shifts()[k]});
    }
  } catch (const Error& error) {
    if (error.code() == ErrorCode::limit_exceeded) return std::nullopt;
  }
  return expected;
}

/// Every state by the algorithms in the forms chosen, by one Detector for all, and by the stages of
/// devices. False at the
/// first state of which nothing is expected.
bool check_states(const Case& given, Thoroughness thoroughness, auto&& expected_of_state) {
  DetectorChecker detector(given);
  CandidateChecker candidates(given.plan.skin);
  DeviceChecker device(given.plan);
  for (std::size_t step = 0; step < given.states.size(); ++step) {
    const System& system = given.states[step];
    const std::optional<Expected> expected = expected_of_state(system);
    if (!expected) return false;
    const Question question(system, *expected);
    const StateChecker state(question, given.plan);
    if (thoroughness == Thoroughness::complete) state.check_completely();
    if (step == 0) state.check_sampled();
    detector.check(state, system, step);
    candidates.check(question);
    state.check_device(device, step);
  }
  return true;
}

}  // namespace

/// Most cases have few images: many of these see more than few with many.
bool check_case(const Case& given, Thoroughness thoroughness) {
  const bool many = given.plan.choices[5] % 16 == 0 || thoroughness == Thoroughness::complete;
  const std::uint64_t most_images = many ? 2500 : 300;
  return check_states(given, thoroughness,
                      [&](const System& system) { return expected_of(system, most_images); });
}

bool check_large_case(const Case& given) {
  return check_states(given, Thoroughness::sampled, by_direct_check);
}

}  // namespace abut::fuzz
