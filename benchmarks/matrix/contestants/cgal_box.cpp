// CGAL's box_self_intersection_d: streamed segment trees (A. Zomorodian, H. Edelsbrunner, "Fast
// software for box intersections", SoCG 2000).

#include "benchmarks/common/packed.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

/// Below so many boxes it compares them along one axis only. The default is 10.
constexpr std::ptrdiff_t fastest_cutoff = 200;

template <int Dim>
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, Dim, ElementIndex>;

class CgalBox final : public Contestant {
 public:
  Answer run(const Scene& scene) override {
    packed_.pack(scene);
    if (scene.dimensions == 2) {
      search(discs_);
    } else {
      search(spheres_);
    }
    return {packed_.pairs(), packed_.pairs().size()};
  }
  [[nodiscard]] Counters counters() const override { return {packed_.candidates(), 0, {}}; }

 private:
  template <int Dim>
  void search(std::vector<Box<Dim>>& boxes) {
    boxes.clear();
    boxes.reserve(packed_.size());
    for (std::size_t k = 0; k < packed_.size(); ++k) {
      double low[Dim];
      double high[Dim];
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        const Bounds<double> side = bounds(packed_[k], axis);
        low[axis] = side.low;
        high[axis] = side.high;
      }
      boxes.emplace_back(low, high, static_cast<ElementIndex>(k));
    }
    CGAL::box_self_intersection_d(
        boxes.begin(), boxes.end(),
        [this](const Box<Dim>& a, const Box<Dim>& b) { packed_.propose(a.info(), b.info()); },
        fastest_cutoff);
  }

  Packed packed_;
  std::vector<Box<2>> discs_;
  std::vector<Box<3>> spheres_;
};

}  // namespace

std::vector<Entry> enter_cgal_box() {
  Entry entry = package_entry("cgal_box", "CGAL " CGAL_VERSION_STR " box_self_intersection_d");
  entry.make = [] { return std::make_unique<CgalBox>(); };
  return {entry};
}

}  // namespace abut::benchmarks
