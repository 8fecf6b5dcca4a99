#include "fuzz/check_device.hpp"

#include "device/host/host_detection.hpp"
#include "device/memory/host_memory.hpp"
#include "fuzz/check_neighbors.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/quantity.hpp>
#include <abut/two_sets.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut::fuzz {
namespace {

using device::ItemOrder;
using device::ListForm;
using testing::HostAnswer;
using testing::HostRun;

void require(bool holds, const std::string& what) {
  if (!holds) throw Failure("stages of devices: " + what);
}

/// One question with all that it is asked by.
class DeviceQuestion {
 public:
  DeviceQuestion(const Question& question, HostRun run)
      : question_(question),
        run_(std::move(run)),
        margin_(question.options().margin),
        first_(question.first()) {
    run_.rule = question.options().rule;
    run_.domain = question.domain();
    if (!question.has_two_sets()) return;
    second_ = question.second();
    run_.second = &*second_;
  }
  DeviceQuestion(const DeviceQuestion&) = delete;
  DeviceQuestion& operator=(const DeviceQuestion&) = delete;

  void check_count() const {
    require(testing::count_on_host(first_, margin_, run_).count == expected().size(),
            "another count");
  }

  /// Gaps have the bits of the library.
  void check_list(Shifts shifts, Quantities quantities) const {
    const HostAnswer answer = asked(ListForm::pairs, shifts, quantities);
    std::vector<ImagePair> found;
    for (std::size_t k = 0; k < answer.pairs.size(); ++k) {
      const bool has_shifts = shifts == Shifts::stored;
      found.push_back({answer.pairs[k], has_shifts ? answer.shifts[k] : ImageShift{}});
    }
    std::vector<ImagePair> pairs = expected();
    if (shifts == Shifts::none) {
      for (ImagePair& image : pairs) image.shift = {};
    }
    require(found == pairs, "another list");
    if (quantities.has(Quantity::gap)) check_gaps(answer);
  }

  void check_rows(NeighborListKind kind) const {
    const bool is_full = kind == NeighborListKind::full && !question_.has_two_sets();
    const HostAnswer answer =
        asked(is_full ? ListForm::full_rows : ListForm::half_rows, Shifts::stored, {});
    const std::vector<ImagePair> entries = expected_entries(question_, kind);
    require(answer.offsets.size() == question_.system().first.size() + 1, "another number of rows");
    require(answer.neighbors.size() == entries.size(), "another number of neighbors");
    for (std::size_t e = 0; e + 1 < answer.offsets.size(); ++e) {
      for (std::uint64_t k = answer.offsets[e]; k < answer.offsets[e + 1]; ++k) {
        const ImagePair found{{static_cast<ElementIndex>(e), answer.neighbors[k]},
                              answer.shifts[k]};
        require(found == entries[k], "another row");
      }
    }
  }

  /// Limits that just do, and one less.
  void check_limits() {
    run_.max_pairs = expected().size();
    check_list(Shifts::stored, {});
    if (expected().empty()) return;
    --run_.max_pairs;
    try {
      static_cast<void>(asked(ListForm::pairs, Shifts::none, {}));
    } catch (const Error& error) {
      if (error.code() == ErrorCode::limit_exceeded) return;
      throw;
    }
    require(false, "a limit of pairs is not kept");
  }

 private:
  [[nodiscard]] const std::vector<ImagePair>& expected() const {
    return question_.expected().pairs;
  }

  [[nodiscard]] HostAnswer asked(ListForm form, Shifts shifts, Quantities quantities) const {
    HostRun run = run_;
    run.form = form;
    run.shifts = shifts;
    run.quantities = quantities;
    return testing::list_on_host(first_, margin_, run);
  }

  void check_gaps(const HostAnswer& answer) const {
    Options options = question_.options();
    options.algorithm = Algorithm::direct_check;
    options.quantities = Quantity::gap;
    const PairList list = FreeFunctions{question_, options}.list();
    require(answer.gaps.size() == list.gaps().size(), "another number of gaps");
    for (std::size_t k = 0; k < answer.gaps.size(); ++k) {
      require(answer.gaps[k] == list.gaps()[k], "another gap");
    }
  }

  const Question& question_;
  HostRun run_;
  double margin_;
  ElementView first_;
  std::optional<ElementView> second_;
};

}  // namespace

DeviceChecker::DeviceChecker(const Plan& plan)
    : plan_(plan), memory_(testing::memory_of_the_host()) {}

void DeviceChecker::check(const Question& question, std::size_t step) {
  const unsigned choice = plan_.choices[(step + 5) % plan_.choices.size()];
  constexpr std::array orders{ItemOrder::ascending, ItemOrder::descending, ItemOrder::shuffled};
  HostRun run{.order = orders[choice % orders.size()]};
  if (choice / 3 % 2 == 0) {
    run.items_at_a_time = 1 + choice % 7;
    run.narrow_places = choice % 5;
  }
  if (choice / 6 % 2 == 0) run.kept = &memory_;
  DeviceQuestion asked(question, std::move(run));
  asked.check_count();
  switch (choice / 12 % 6) {
    case 0:
      return asked.check_list(Shifts::stored, {});
    case 1:
      return asked.check_list(Shifts::none, {});
    case 2:
      return asked.check_list(Shifts::stored, Quantity::gap);
    case 3:
      return asked.check_rows(NeighborListKind::half);
    case 4:
      return asked.check_rows(NeighborListKind::full);
    default:
      return asked.check_limits();
  }
}

}  // namespace abut::fuzz
