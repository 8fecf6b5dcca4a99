// What the processors of the machine give: arithmetic in registers, which waits for no memory, in
// one thread and in several. Where two threads are less than twice as fast here, processors are
// shared, and no program can be.

#include "benchmarks/matrix/contestant.hpp"
#include "benchmarks/matrix/pinning.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <thread>
#include <vector>

namespace abut::benchmarks {
namespace {

/// Steps for each element, so that one takes some 15 ns, as a search does.
constexpr int steps = 8;

/// Returns what the compiler cannot know, so that it must run all steps of a share of the elements.
double work_off(std::size_t elements) {
  std::array<double, 8> chains{1, 2, 3, 4, 5, 6, 7, 8};
  for (std::size_t k = 0; k < elements; ++k) {
    for (int step = 0; step < steps; ++step) {
      for (double& x : chains) x = 0.75 * x + 0.25;
    }
  }
  double sum = 0.0;
  for (const double x : chains) sum += x;
  return sum;
}

class ControlLoop final : public Contestant {
 public:
  explicit ControlLoop(std::size_t threads) : sums_(threads) {}

  Answer run(const scenes::Scene& scene) override {
    const std::size_t share = scene.size() / sums_.size();
    {
      std::vector<std::jthread> helpers;
      for (std::size_t k = 1; k < sums_.size(); ++k) {
        helpers.emplace_back([this, k, share] {
          pin_to_processor(k);
          sums_[k] = work_off(share);
        });
      }
      sums_[0] = work_off(share);
    }
    for (const double sum : sums_) seen_ = sum;
    return {};
  }

 private:
  std::vector<double> sums_;
  volatile double seen_ = 0.0;
};

}  // namespace

std::vector<Entry> enter_control_loop() {
  std::vector<Entry> entries;
  for (const int threads : {1, 2, 4, 8, 16}) {
    Entry entry;
    entry.name = "control_loop";
    entry.description = "arithmetic in registers: what the processors give";
    entry.task = Task::control;
    entry.threads = threads;
    entry.make = [threads] {
      return std::make_unique<ControlLoop>(static_cast<std::size_t>(threads));
    };
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace abut::benchmarks
