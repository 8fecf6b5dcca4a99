// The longest silence of each phase: basic blocks that are entered between two questions to the
// progress hook, in systems large enough that a loop which asks nobody shows. The count depends on
// no clock and no other load. See scripts/measure-silence.

#include "silence/block_counter.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// In blocks. Questions come after 65,536 steps of some blocks each.
constexpr std::uint64_t longest_allowed = 10'000'000;

/// Besides, these builds count a block for each entry of an array that grows, where others do
/// nothing: of the full list of `dense`, two arrays one after the other.
constexpr std::uint64_t blocks_of_growing_lists = 2 * 6'100'000;

/// Longest silences by phase, and the last one after all questions.
class Listener {
 public:
  [[nodiscard]] ProgressHook hook() {
    return [this](const Progress& progress) {
      note(std::string(progress.phase));
      return ProgressAction::proceed;
    };
  }

  void start() { asked_at_ = entered_blocks(); }
  void note(const std::string& phase) {
    std::uint64_t& longest = longest_[phase];
    longest = std::max(longest, entered_blocks() - asked_at_);
    asked_at_ = entered_blocks();
  }
  [[nodiscard]] const std::map<std::string, std::uint64_t>& longest() const { return longest_; }

 private:
  std::uint64_t asked_at_ = 0;
  std::map<std::string, std::uint64_t> longest_;
};

struct Task {
  std::string name;
  std::function<void(const Options&)> run;
  std::uint64_t growing = 0;  ///< blocks of arrays that grow
};

Scene made(const char* name, std::size_t count) {
  return scenes::scene_named(name).make(count, 1);
}

const Scene& dense() {
  static const Scene scene = made("dense", 1'000'000);
  return scene;
}

const Scene& mixed() {
  static const Scene scene = made("log_uniform", 300'000);
  return scene;
}

const Scene& graded() {
  static const Scene scene = made("graded_1000", 300'000);
  return scene;
}

const Scene& crowd() {
  static const Scene scene = made("coincident", 4'000);
  return scene;
}

const Domain& cell() {
  static const Domain domain = Domain::periodic({200.0, 200.0, 200.0});
  return domain;
}

Options with(Options options, Shifts shifts, Quantities quantities) {
  options.shifts = shifts;
  options.quantities = quantities;
  return options;
}

void add_lists(std::vector<Task>& tasks) {
  tasks.push_back({"list", [](const Options& options) {
                     static_cast<void>(
                         find_contact_pairs(view_of(dense()), Domain::open(), options));
                   }});
  tasks.push_back({"list as found", [](const Options& options) {
                     Options as_found = options;
                     as_found.order = Order::as_found;
                     static_cast<void>(
                         find_contact_pairs(view_of(dense()), Domain::open(), as_found));
                   }});
  tasks.push_back({"list of mixed sizes", [](const Options& options) {
                     static_cast<void>(
                         find_contact_pairs(view_of(mixed()), Domain::open(), options));
                   }});
  tasks.push_back({"list of sizes in layers", [](const Options& options) {
                     static_cast<void>(
                         find_contact_pairs(view_of(graded()), Domain::open(), options));
                   }});
  tasks.push_back({"list of a crowd", [](const Options& options) {
                     static_cast<void>(
                         find_contact_pairs(view_of(crowd()), Domain::open(), options));
                   }});
  tasks.push_back({"periodic list", [](const Options& options) {
                     static_cast<void>(find_contact_pairs(view_of(dense()), cell(),
                                                          with(options, Shifts::stored, {})));
                   }});
  tasks.push_back({"neighbor list with data",
                   [](const Options& options) {
                     static_cast<void>(build_neighbor_list(
                         view_of(dense()), cell(), NeighborListKind::full,
                         with(options, Shifts::stored, Quantity::distance | Quantity::vector)));
                   },
                   blocks_of_growing_lists});
  tasks.push_back({"two sets", [](const Options& options) {
                     static_cast<void>(find_contact_pairs(view_of(dense()), view_of(mixed()),
                                                          Domain::open(), options));
                   }});
}

void add_steps(std::vector<Task>& tasks) {
  for (const bool periodic : {false, true}) {
    tasks.push_back({periodic ? "periodic skin" : "skin", [periodic](const Options& options) {
                       const Domain domain = periodic ? cell() : Domain::open();
                       Detector detector(options);
                       detector.set_skin(Skin::fixed(0.1));
                       for (int step = 0; step < 2; ++step) {
                         detector.find_contact_pairs(view_of(dense()), domain);
                       }
                     }});
  }
}

void add_walls(std::vector<Task>& tasks) {
  tasks.push_back({"boxes", [](const Options& options) {
                     const std::vector<double> low{-5.0, 20.0}, high{200.0, 21.0};
                     static_cast<void>(find_box_contacts(
                         view_of(dense()), boxes(low, low, low, high, high, high), options));
                   }});
}

std::vector<Task> all_tasks() {
  std::vector<Task> tasks;
  add_lists(tasks);
  add_steps(tasks);
  add_walls(tasks);
  return tasks;
}

/// Returns whether no silence was too long.
bool measure(const Task& task) {
  Listener listener;
  Options options;
  options.threads = 1;
  options.progress = listener.hook();
  listener.start();
  task.run(options);
  listener.note("after the last question");
  bool fine = true;
  for (const auto& [phase, blocks] : listener.longest()) {
    std::printf("%-28s%-28s%12llu\n", task.name.c_str(), phase.c_str(),
                static_cast<unsigned long long>(blocks));
    fine = fine && blocks <= longest_allowed + task.growing;
  }
  std::fflush(stdout);
  return fine;
}

}  // namespace
}  // namespace abut::testing

int main() {
  try {
    bool fine = true;
    for (const auto& task : abut::testing::all_tasks()) {
      fine = abut::testing::measure(task) && fine;
    }
    if (abut::testing::entered_blocks() == 0) std::puts("built without counters");
    return fine ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
