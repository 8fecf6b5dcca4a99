// The detections of the relations: those of the library, by all of its algorithms.

#include "properties/systems.hpp"
#include "support/algorithm_list.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <algorithm>
#include <functional>
#include <iostream>
#include <string>

namespace abut::testing {

PairVector pairs_of(const Scene& scene, Algorithm algorithm, double margin) {
  Options options{.algorithm = algorithm, .margin = margin};
  if (algorithm == Algorithm::rows) {
    options.simd = *rc::gen::elementOf(simd_levels_here());
    // Often one: to start many takes longer than such small systems.
    options.threads = *rc::gen::weightedElement<int>({{4, 1}, {1, 2}, {1, 3}, {1, 7}, {1, 16}});
  }
  const bool as_float = fits_float(scene) && *rc::gen::arbitrary<bool>();
  RC_LOG() << name_of(options.simd) << ", " << options.threads << " threads, "
           << (as_float ? "float" : "double") << std::endl;
  const PairList list =
      as_float ? find_contact_pairs(Float32Scene(scene).view(), Domain::open(), options)
               : find_contact_pairs(view_of(scene), Domain::open(), options);
  if (algorithm == Algorithm::rows) {
    RC_ASSERT(list.statistics().simd == options.simd);
    const auto elements = static_cast<int>(list.statistics().elements);
    RC_ASSERT(list.statistics().threads == std::min(options.threads, std::max(elements, 1)));
  }
  return {list.begin(), list.end()};
}

void for_each_algorithm(const Scene& scene, const std::function<void(Algorithm)>& relation) {
  for (const Algorithm algorithm : algorithms_for(scene.dimensions)) {
    RC_LOG() << "algorithm " << std::string(name_of(algorithm)) << std::endl;
    relation(algorithm);
  }
}

}  // namespace abut::testing
