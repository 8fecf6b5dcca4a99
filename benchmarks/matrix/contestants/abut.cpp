// Every algorithm of abut's registry, through the public face.

#include "benchmarks/matrix/contestant.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>

#include <algorithm>
#include <array>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

ElementView view(const Scene& scene) {
  if (scene.dimensions == 2) return discs(scene.x, scene.y, scene.radius);
  return spheres(scene.x, scene.y, scene.z, scene.radius);
}

class AbutContestant final : public Contestant {
 public:
  AbutContestant(Task task, Algorithm algorithm, int threads) : task_(task) {
    options_.algorithm = algorithm;
    options_.threads = threads;
    options_.order = task == Task::canonical ? Order::canonical : Order::as_found;
  }

  Answer run(const Scene& scene) override {
    list_ = {};
    const ElementView elements = view(scene);
    switch (task_) {
      case Task::count:
        statistics_ = count_contact_pairs(elements, Domain::open(), options_);
        return {{}, statistics_.contact_pairs};
      case Task::visit:
        return {{}, visit(elements)};
      default:
        list_ = find_contact_pairs(elements, Domain::open(), options_);
        statistics_ = list_.statistics();
        if (statistics_.threads < options_.threads) {
          throw Error(ErrorCode::unavailable, "runs in one thread");
        }
        return {list_.pairs(), list_.size()};
    }
  }

  [[nodiscard]] Counters counters() const override {
    return {statistics_.candidate_tests, statistics_.peak_bytes,
            std::string(name_of(statistics_.algorithm)) + ": " + statistics_.reason};
  }

 private:
  /// A visitor that does next to nothing, but with each pair.
  std::uint64_t visit(const ElementView& elements) {
    std::uint64_t count = 0;
    std::uint64_t sum = 0;
    statistics_ =
        for_each_contact_pair(elements, Domain::open(), options_, [&](const ContactPair& pair) {
          ++count;
          sum += pair.second - pair.first;
        });
    return sum < count ? 0 : count;
  }

  Task task_;
  Options options_;
  PairList list_;
  Statistics statistics_;
};

Entry entry_of(Algorithm algorithm, Task task, int threads) {
  Entry entry;
  entry.name = "abut_" + std::string(name_of(algorithm));
  entry.description = algorithm == Algorithm::automatic ? "abut, choosing by itself"
                                                        : std::string(info(algorithm).idea);
  entry.task = task;
  entry.threads = threads;
  if (algorithm == Algorithm::direct_check) {
    entry.most_elements = 20'000;
    entry.reason_of_limit = "its time grows with the square of N";
  }
  entry.make = [=] { return std::make_unique<AbutContestant>(task, algorithm, threads); };
  return entry;
}

/// Those beyond the book are meant for use, and measured in every way.
bool for_use(const AlgorithmInfo& algorithm) {
  constexpr std::array of_the_book{Algorithm::direct_check, Algorithm::binary_tree,
                                   Algorithm::screening_array, Algorithm::sorting_array,
                                   Algorithm::munjiza_nbs};
  return std::find(of_the_book.begin(), of_the_book.end(), algorithm.algorithm) ==
         of_the_book.end();
}

}  // namespace

std::vector<Entry> enter_abut() {
  std::vector<Algorithm> all{Algorithm::automatic};
  for (const AlgorithmInfo& algorithm : algorithms()) {
    if (for_use(algorithm)) all.push_back(algorithm.algorithm);
  }
  std::vector<Entry> entries;
  for (const Algorithm algorithm : all) {
    for (const Task task : {Task::list, Task::canonical, Task::count, Task::visit}) {
      entries.push_back(entry_of(algorithm, task, 1));
    }
    for (const int threads : {2, 4, 8, 16}) {
      entries.push_back(entry_of(algorithm, Task::list, threads));
    }
  }
  for (const AlgorithmInfo& algorithm : algorithms()) {
    if (!for_use(algorithm)) entries.push_back(entry_of(algorithm.algorithm, Task::list, 1));
  }
  return entries;
}

}  // namespace abut::benchmarks
