#pragma once

#include "support/scene_view.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace abut::testing {

/// A scene in three dimensions whose numbers lie in memory in the ways that callers have. All
/// numbers must be floats, so that single precision has the same elements.
class SceneLayouts {
 public:
  explicit SceneLayouts(const scenes::Scene& scene) : scene_(scene), singles_(scene) {
    for (std::size_t k = 0; k < scene.size(); ++k) {
      const auto [x, y, z, r] = std::array{scene.x[k], scene.y[k], scene.z[k], scene.radius[k]};
      points_.push_back({x, y, z});
      particles_.push_back({x, y, z, r});
      wide_.push_back({NAN, z, NAN, x, NAN, y, r});
    }
  }

  /// Single precision, which must be converted and packed.
  [[nodiscard]] ElementView singles() const { return singles_.view(); }

  /// Layouts that can be read where they are.
  [[nodiscard]] std::vector<ElementView> in_place() const {
    return {view_of(scene_), spheres(points_, scene_.radius), of_members(particles_),
            of_members(wide_)};
  }

 private:
  struct Particle {
    double x, y, z, radius;
  };
  struct WideParticle {
    double velocity, z, mass, x, charge, y, radius;
  };

  template <class P>
  static ElementView of_members(const std::vector<P>& all) {
    return spheres(column(all, &P::x), column(all, &P::y), column(all, &P::z),
                   column(all, &P::radius));
  }

  const scenes::Scene& scene_;
  Float32Scene singles_;
  std::vector<std::array<double, 3>> points_;
  std::vector<Particle> particles_;
  std::vector<WideParticle> wide_;
};

}  // namespace abut::testing
