// Every algorithm of abut's registry, through the public face. A Detector keeps the memory.

#include "benchmarks/matrix/contestant.hpp"

#include <abut/detector.hpp>
#include <abut/error.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

ElementView view(const Scene& scene) {
  if (scene.dimensions == 2) return discs(scene.x, scene.y, scene.radius);
  return spheres(scene.x, scene.y, scene.z, scene.radius);
}

Options options_of(Task task, Algorithm algorithm, int threads) {
  Options options;
  options.algorithm = algorithm;
  options.threads = threads;
  options.order = task == Task::canonical ? Order::canonical : Order::as_found;
  return options;
}

class AbutContestant final : public Contestant {
 public:
  AbutContestant(Task task, Algorithm algorithm, int threads)
      : task_(task), detector_(options_of(task, algorithm, threads)) {}

  Answer run(const Scene& scene) override {
    const Answer answer = detect(view(scene));
    if (scene.size() > 0 && statistics_.threads < detector_.options().threads) {
      throw Error(ErrorCode::unavailable, "runs in one thread");
    }
    return answer;
  }

  [[nodiscard]] Counters counters() const override {
    return {statistics_.candidate_tests, statistics_.peak_bytes,
            std::string(name_of(statistics_.algorithm)) + ": " + std::string(statistics_.reason)};
  }

 private:
  Answer detect(const ElementView& elements) {
    switch (task_) {
      case Task::count:
        statistics_ = detector_.count_contact_pairs(elements);
        return {{}, statistics_.contact_pairs};
      case Task::visit:
        return {{}, visit(elements)};
      case Task::half_list:
        return {{}, neighbors(elements, NeighborListKind::half)};
      case Task::full_list:
        return {{}, neighbors(elements, NeighborListKind::full) / 2};
      default:
        const PairList& list = detector_.find_contact_pairs(elements);
        statistics_ = list.statistics();
        return {list.pairs(), list.size()};
    }
  }

  std::uint64_t neighbors(const ElementView& elements, NeighborListKind kind) {
    const NeighborList& list = detector_.build_neighbor_list(elements, Domain::open(), kind);
    statistics_ = list.statistics();
    return list.neighbors().size();
  }

  /// A visitor that does next to nothing, but with each pair.
  std::uint64_t visit(const ElementView& elements) {
    std::uint64_t count = 0;
    statistics_ = detector_.for_each_batch(elements, Domain::open(),
                                           [&](std::span<const ContactPair> pairs, WorkerNumber) {
                                             for (const ContactPair& pair : pairs)
                                               count += pair.first < pair.second ? 1U : 0U;
                                           });
    return count;
  }

  Task task_;
  Detector detector_;
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
  } else if (algorithm != Algorithm::automatic && algorithm != Algorithm::rows) {
    entry.most_elements = 1'000'000;
    entry.reason_of_limit = "the algorithms of the book are measured up to 10^6 elements";
  }
  entry.make = [=] { return std::make_unique<AbutContestant>(task, algorithm, threads); };
  return entry;
}

}  // namespace

/// The default algorithm with every task, the algorithms of the registry with lists.
std::vector<Entry> enter_abut() {
  std::vector<Entry> entries;
  for (const Task task :
       {Task::list, Task::canonical, Task::count, Task::visit, Task::half_list, Task::full_list}) {
    entries.push_back(entry_of(Algorithm::automatic, task, 1));
  }
  for (const int threads : {2, 4, 8, 16}) {
    entries.push_back(entry_of(Algorithm::automatic, Task::list, threads));
  }
  for (const AlgorithmInfo& algorithm : algorithms()) {
    entries.push_back(entry_of(algorithm.algorithm, Task::list, 1));
  }
  return entries;
}

}  // namespace abut::benchmarks
