#include "benchmarks/systems/contestants/cgal_two_sets.hpp"

#include "benchmarks/common/cgal_boxes.hpp"
#include "benchmarks/common/packed.hpp"

namespace abut::benchmarks {

/// Elements of one set, and their boxes.
struct CgalOfTwoSets::Set {
  void take(const scenes::Scene& scene) {
    packed.pack(scene);
    boxes.fill(packed.size(),
               [this](std::size_t k, std::size_t axis) { return bounds(packed[k], axis); });
  }

  Packed packed;
  CgalBoxes<3> boxes;
};

CgalOfTwoSets::CgalOfTwoSets()
    : first_(std::make_unique<Set>()), second_(std::make_unique<Set>()) {}
CgalOfTwoSets::~CgalOfTwoSets() = default;

const std::vector<ContactPair>& CgalOfTwoSets::run(const TwoScenes& sets) {
  first_->take(sets.first);
  second_->take(sets.second);
  pairs_.clear();
  first_->boxes.for_each_pair_with(second_->boxes, [this](ElementIndex a, ElementIndex b) {
    if (touching(first_->packed[a], second_->packed[b])) pairs_.push_back({a, b});
  });
  return pairs_;
}

}  // namespace abut::benchmarks
