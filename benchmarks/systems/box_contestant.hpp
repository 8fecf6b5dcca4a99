#pragma once

#include "scenes/box_scene.hpp"

#include <abut/pair.hpp>

#include <functional>
#include <string>
#include <vector>

namespace abut::benchmarks {

/// Who finds the pairs of boxes that touch. A run begins with the columns of the scene and ends
/// with all pairs in memory, which may be kept from run to run.
struct BoxContestant {
  std::string name;
  std::function<const std::vector<ContactPair>&(const scenes::BoxScene&)> run;
};

/// CGAL's box_self_intersection_d, and Bullet's btDbvt; one contestant each.
[[nodiscard]] std::vector<BoxContestant> enter_cgal_boxes();
[[nodiscard]] std::vector<BoxContestant> enter_bullet_boxes();

}  // namespace abut::benchmarks
