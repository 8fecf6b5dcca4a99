// CGAL's box_self_intersection_d, then the plain test.

#include "benchmarks/common/cgal_boxes.hpp"
#include "benchmarks/common/packed.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <CGAL/version.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

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
  void search(CgalBoxes<Dim>& boxes) {
    boxes.fill(packed_.size(),
               [this](std::size_t k, std::size_t axis) { return bounds(packed_[k], axis); });
    boxes.for_each_pair([this](ElementIndex a, ElementIndex b) { packed_.propose(a, b); });
  }

  Packed packed_;
  CgalBoxes<2> discs_;
  CgalBoxes<3> spheres_;
};

}  // namespace

std::vector<Entry> enter_cgal_box() {
  Entry entry = package_entry("cgal_box", "CGAL " CGAL_VERSION_STR " box_self_intersection_d");
  entry.make = [] { return std::make_unique<CgalBox>(); };
  return {entry};
}

}  // namespace abut::benchmarks
