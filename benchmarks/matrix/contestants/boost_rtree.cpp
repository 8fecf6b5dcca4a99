// Boost.Geometry's R-tree of boxes, packed from all of them at once.

#include "benchmarks/common/packed.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/version.hpp>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace abut::benchmarks {
namespace {

namespace bg = boost::geometry;
using scenes::Scene;

template <std::size_t Dim>
using Point = bg::model::point<double, Dim, bg::cs::cartesian>;
template <std::size_t Dim>
using Value = std::pair<bg::model::box<Point<Dim>>, ElementIndex>;

template <std::size_t Dim>
Value<Dim> value_of(const PackedElement& element, ElementIndex k) {
  const Bounds<double> x = bounds(element, 0);
  const Bounds<double> y = bounds(element, 1);
  if constexpr (Dim == 2) {
    return {{{x.low, y.low}, {x.high, y.high}}, k};
  } else {
    const Bounds<double> z = bounds(element, 2);
    return {{{x.low, y.low, z.low}, {x.high, y.high, z.high}}, k};
  }
}

class BoostRtree final : public Contestant {
 public:
  Answer run(const Scene& scene) override {
    packed_.pack(scene);
    if (scene.dimensions == 2) {
      search<2>(discs_);
    } else {
      search<3>(spheres_);
    }
    return {packed_.pairs(), packed_.pairs().size()};
  }
  [[nodiscard]] Counters counters() const override { return {packed_.candidates(), 0, {}}; }

 private:
  template <std::size_t Dim>
  void search(std::vector<Value<Dim>>& values) {
    values.clear();
    for (std::size_t k = 0; k < packed_.size(); ++k) {
      values.push_back(value_of<Dim>(packed_[k], static_cast<ElementIndex>(k)));
    }
    const bg::index::rtree<Value<Dim>, bg::index::rstar<16>> tree(values.begin(), values.end());
    // In the order of the tree, so that one question finds in the caches what the last one read.
    for (const auto& [box, own] : tree) {
      const auto take = [this, own = own](const Value<Dim>& other) {
        if (own < other.second) packed_.propose(own, other.second);
      };
      tree.query(bg::index::intersects(box), boost::make_function_output_iterator(take));
    }
  }

  Packed packed_;
  std::vector<Value<2>> discs_;
  std::vector<Value<3>> spheres_;
};

}  // namespace

std::vector<Entry> enter_boost_rtree() {
  Entry entry = package_entry("boost_rtree", "Boost " BOOST_LIB_VERSION " R-tree, bulk loaded");
  entry.make = [] { return std::make_unique<BoostRtree>(); };
  return {entry};
}

}  // namespace abut::benchmarks
