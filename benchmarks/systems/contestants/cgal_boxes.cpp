// CGAL's box_self_intersection_d: streamed segment trees (A. Zomorodian, H. Edelsbrunner, "Fast
// software for box intersections", SoCG 2000). Its closed boxes in double are those of the
// contract.

#include "benchmarks/systems/box_contestant.hpp"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <memory>

namespace abut::benchmarks {
namespace {

/// Below so many boxes it compares them along one axis only. The default is 10.
constexpr std::ptrdiff_t fastest_cutoff = 200;

template <int Dim>
class Cgal {
 public:
  const std::vector<ContactPair>& run(const scenes::BoxScene& scene) {
    boxes_.clear();
    boxes_.reserve(scene.size());
    pairs_.clear();
    for (std::size_t k = 0; k < scene.size(); ++k) {
      double low[Dim];
      double high[Dim];
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        low[axis] = scene.lower[axis][k];
        high[axis] = scene.upper[axis][k];
      }
      boxes_.emplace_back(low, high, static_cast<ElementIndex>(k));
    }
    CGAL::box_self_intersection_d(
        boxes_.begin(), boxes_.end(),
        [this](const Box& a, const Box& b) {
          pairs_.push_back({std::min(a.info(), b.info()), std::max(a.info(), b.info())});
        },
        fastest_cutoff);
    return pairs_;
  }

 private:
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, Dim, ElementIndex>;

  std::vector<Box> boxes_;
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
