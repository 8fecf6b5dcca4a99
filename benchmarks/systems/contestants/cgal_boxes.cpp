// CGAL's box_self_intersection_d. Its closed boxes in double are those of the contract.

#include "benchmarks/common/cgal_boxes.hpp"

#include "benchmarks/systems/box_contestant.hpp"

#include <algorithm>
#include <memory>

namespace abut::benchmarks {
namespace {

template <int Dim>
class Cgal {
 public:
  const std::vector<ContactPair>& run(const scenes::BoxScene& scene) {
    boxes_.fill(scene.size(), [&](std::size_t k, std::size_t axis) {
      return Bounds<double>{scene.lower[axis][k], scene.upper[axis][k]};
    });
    pairs_.clear();
    boxes_.for_each_pair([this](ElementIndex a, ElementIndex b) {
      pairs_.push_back({std::min(a, b), std::max(a, b)});
    });
    return pairs_;
  }

 private:
  CgalBoxes<Dim> boxes_;
  std::vector<ContactPair> pairs_;
};

}  // namespace

std::vector<BoxContestant> enter_cgal_boxes() {
  return {{"cgal_box",
           [in_2d = std::make_shared<Cgal<2>>(), in_3d = std::make_shared<Cgal<3>>()](
               const scenes::BoxScene& scene) -> const std::vector<ContactPair>& {
             return scene.dimensions == 2 ? in_2d->run(scene) : in_3d->run(scene);
           }}};
}

}  // namespace abut::benchmarks
