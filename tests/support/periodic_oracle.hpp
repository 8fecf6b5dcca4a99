#pragma once

#include "scenes/box_scene.hpp"
#include "scenes/scene.hpp"

#include <abut/domain.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <compare>
#include <cstdint>
#include <vector>

/// The contract in periodic domains, computed without any of the library.
namespace abut::testing {

/// A contact pair with its image shift.
struct ImagePair {
  ContactPair pair;
  ImageShift shift;

  friend auto operator<=>(const ImagePair&, const ImagePair&) = default;
};

/// All contact pairs in canonical order: rational arithmetic on every image shift up to
/// `farthest` along each periodic axis. Fails the test when a pair lies on that border, because
/// others may lie beyond.
[[nodiscard]] std::vector<ImagePair> oracle_image_pairs(const scenes::Scene& scene,
                                                        const Domain& domain, double margin,
                                                        std::int32_t farthest);

/// The same of boxes.
[[nodiscard]] std::vector<ImagePair> oracle_image_pairs(const scenes::BoxScene& scene,
                                                        const Domain& domain, double margin,
                                                        std::int32_t farthest);

}  // namespace abut::testing
