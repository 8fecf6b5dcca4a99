#pragma once

#include "benchmarks/systems/two_scenes.hpp"

#include <abut/pair.hpp>

#include <memory>
#include <vector>

namespace abut::benchmarks {

/// CGAL's box_intersection_d of two sets, with a test of the distance in double.
class CgalOfTwoSets {
 public:
  CgalOfTwoSets();
  ~CgalOfTwoSets();

  const std::vector<ContactPair>& run(const TwoScenes& sets);

 private:
  struct Set;
  std::unique_ptr<Set> first_;
  std::unique_ptr<Set> second_;
  std::vector<ContactPair> pairs_;
};

}  // namespace abut::benchmarks
