#include "benchmarks/systems/contestants/cgal_two_sets.hpp"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

namespace abut::benchmarks {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, ElementIndex>;

/// Below so many boxes it compares them along one axis only. The default is 10.
constexpr std::ptrdiff_t fastest_cutoff = 200;

void put_into_boxes(const scenes::Scene& scene, std::vector<Box>& boxes) {
  boxes.clear();
  boxes.reserve(scene.size());
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const double r = scene.radius[k];
    double low[] = {scene.x[k] - r, scene.y[k] - r, scene.z[k] - r};
    double high[] = {scene.x[k] + r, scene.y[k] + r, scene.z[k] + r};
    boxes.emplace_back(low, high, static_cast<ElementIndex>(k));
  }
}

bool touch(const scenes::Scene& a, std::size_t i, const scenes::Scene& b, std::size_t j) {
  const double x = a.x[i] - b.x[j];
  const double y = a.y[i] - b.y[j];
  const double z = a.z[i] - b.z[j];
  const double reach = a.radius[i] + b.radius[j];
  return x * x + y * y + z * z <= reach * reach;
}

}  // namespace

struct CgalOfTwoSets::Boxes {
  std::vector<Box> first;
  std::vector<Box> second;
};

CgalOfTwoSets::CgalOfTwoSets() : boxes_(std::make_unique<Boxes>()) {}
CgalOfTwoSets::~CgalOfTwoSets() = default;

const std::vector<ContactPair>& CgalOfTwoSets::run(const TwoScenes& sets) {
  put_into_boxes(sets.first, boxes_->first);
  put_into_boxes(sets.second, boxes_->second);
  pairs_.clear();
  CGAL::box_intersection_d(
      boxes_->first.begin(), boxes_->first.end(), boxes_->second.begin(), boxes_->second.end(),
      [&](const Box& a, const Box& b) {
        if (touch(sets.first, a.info(), sets.second, b.info())) {
          pairs_.push_back({a.info(), b.info()});
        }
      },
      fastest_cutoff);
  return pairs_;
}

}  // namespace abut::benchmarks
