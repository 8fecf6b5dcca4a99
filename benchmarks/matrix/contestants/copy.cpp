// The yardstick of the machine: how long a copy of the caller's arrays takes.

#include "benchmarks/matrix/contestant.hpp"
#include "benchmarks/matrix/huge_array.hpp"

#include <cstring>
#include <memory>
#include <vector>

namespace abut::benchmarks {
namespace {

class Copy final : public Contestant {
 public:
  Answer run(const scenes::Scene& scene) override {
    const std::size_t count = scene.size();
    copy_.ensure(4 * count);
    double* to = copy_.data();
    for (const auto* column : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
      if (!column->empty()) std::memcpy(to, column->data(), column->size() * sizeof(double));
      to += column->size();
    }
    return {};
  }

 private:
  HugeArray<double> copy_;
};

}  // namespace

std::vector<Entry> enter_copy() {
  Entry entry;
  entry.name = "memcpy";
  entry.description = "a copy of the arrays of positions and radii";
  entry.task = Task::copy;
  entry.make = [] { return std::make_unique<Copy>(); };
  return {entry};
}

}  // namespace abut::benchmarks
