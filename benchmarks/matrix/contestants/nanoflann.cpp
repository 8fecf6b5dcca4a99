// nanoflann: a k-d tree of the centres. Each element asks for those that are no larger than it,
// within twice its own radius: small elements need not look as far as the largest would reach.

#include "benchmarks/common/packed.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <nanoflann.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

/// The interface that nanoflann wants of a cloud of points.
struct Cloud {
  const Packed* packed = nullptr;

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return packed->size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t k, std::size_t axis) const {
    return (*packed)[k].center[axis];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

template <int Dim>
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud,
                                                 Dim, ElementIndex>;

/// The interface that nanoflann wants of a set of results: tests each point at once.
class Hits {
 public:
  using DistanceType = double;
  using IndexType = ElementIndex;

  Hits(Packed& packed, ElementIndex own) : packed_(packed), own_(own), radius_(packed[own].radius) {
    // A hair more: the tree leaves out points at the very distance.
    squared_ = 4.0 * radius_ * radius_ * (1.0 + 1e-9) + std::numeric_limits<double>::min();
  }

  [[nodiscard]] double worstDist() const { return squared_; }
  [[nodiscard]] static bool full() { return true; }

  bool addPoint(double distance_squared, ElementIndex other) {
    ++tests_;
    const double radius = packed_[other].radius;
    const bool own_task = radius < radius_ || (radius == radius_ && other < own_);
    const double reach = radius + radius_;
    if (own_task && distance_squared <= reach * reach) packed_.keep(own_, other);
    return true;
  }

  [[nodiscard]] std::uint64_t tests() const { return tests_; }

 private:
  Packed& packed_;
  ElementIndex own_;
  double radius_;
  double squared_ = 0.0;
  std::uint64_t tests_ = 0;
};

class Nanoflann final : public Contestant {
 public:
  Answer run(const Scene& scene) override {
    packed_.pack(scene);
    tests_ = 0;
    if (packed_.size() > 0) {
      if (scene.dimensions == 2) {
        search<2>();
      } else {
        search<3>();
      }
    }
    return {packed_.pairs(), packed_.pairs().size()};
  }
  [[nodiscard]] Counters counters() const override { return {tests_, 0, {}}; }

 private:
  template <int Dim>
  void search() {
    const Cloud cloud{&packed_};
    const Tree<Dim> tree(Dim, cloud);
    // In the order of the tree, so that one question finds in the caches what the last one read.
    for (const ElementIndex own : tree.vAcc) {
      Hits hits(packed_, own);
      tree.findNeighbors(hits, packed_[own].center.data(), nanoflann::SearchParams());
      tests_ += hits.tests();
    }
  }

  Packed packed_;
  std::uint64_t tests_ = 0;
};

}  // namespace

std::vector<Entry> enter_nanoflann() {
  Entry entry = package_entry("nanoflann", "nanoflann, a k-d tree");
  entry.make = [] { return std::make_unique<Nanoflann>(); };
  return {entry};
}

}  // namespace abut::benchmarks
