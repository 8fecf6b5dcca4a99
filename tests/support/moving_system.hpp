#pragma once

#include "scenes/random.hpp"
#include "scenes/scene.hpp"
#include "support/scene_view.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace abut::testing {

/// The domains that a system may move in.
enum class Space { open, periodic, slit, triclinic, swelling, lees_edwards };

inline constexpr std::array<Space, 6> all_spaces{Space::open,     Space::periodic,
                                                 Space::slit,     Space::triclinic,
                                                 Space::swelling, Space::lees_edwards};

[[nodiscard]] inline const char* name_of(Space space) {
  constexpr std::array<const char*, 6> names{"open",      "periodic", "slit",
                                             "triclinic", "swelling", "lees_edwards"};
  return names[static_cast<std::size_t>(space)];
}

/// What a moving system does beside moving.
struct Motion {
  Space space = Space::open;
  double speed = 0.01;   ///< way of an element in a step, in units of the mean radius of 0.5
  double growth = 0.0;   ///< of all radii in a step
  bool wrapped = false;  ///< whether elements are kept in the cell
};

/// Random spheres or discs, of about one contact each, that fly through a domain.
class MovingSystem {
 public:
  MovingSystem(int dimensions, std::size_t count, const Motion& motion, std::uint64_t seed)
      : motion_(motion), random_(seed) {
    scene.dimensions = dimensions;
    side_ = dimensions == 2 ? std::sqrt(static_cast<double>(count)) * 1.1
                            : std::cbrt(static_cast<double>(count)) * 1.0;
    for (std::size_t k = 0; k < count; ++k) add();
  }

  [[nodiscard]] ElementView elements() const { return view_of(scene); }
  [[nodiscard]] double side() const { return side_; }

  [[nodiscard]] Domain domain() const {
    const double l = side_;
    if (motion_.space == Space::open) return Domain::open();
    if (scene.dimensions == 2) return domain_2d(l);
    switch (motion_.space) {
      case Space::slit:
        return Domain::periodic({l, unbounded, l});
      case Space::triclinic:
        return Domain::lattice({l, 0, 0}, {0.7 * l, l, 0}, {-0.3 * l, 0.4 * l, l});
      case Space::swelling: {
        const double a = l * (1.0 + 0.0002 * time_);
        return Domain::lattice({a, 0.001 * time_, 0}, {0.2 * a, a, 0}, {0, -0.001 * time_, a});
      }
      case Space::lees_edwards:
        return Domain::lees_edwards({l, l, l}, 0.013 * time_);
      default:
        return Domain::periodic({l, l, l});
    }
  }

  void step() {
    ++time_;
    for (std::size_t k = 0; k < scene.size(); ++k) {
      for (std::size_t axis = 0; axis < axes(); ++axis) {
        velocity_[k][axis] =
            0.98 * velocity_[k][axis] + 0.1 * motion_.speed * random_.uniform(-1.0, 1.0);
        coordinates(axis)[k] += velocity_[k][axis];
      }
      scene.radius[k] += motion_.growth;
    }
    if (motion_.wrapped) wrap();
  }

  void add() {
    velocity_.push_back({});
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      coordinates(axis).push_back(random_.uniform(0.0, side_));
      velocity_.back()[axis] = 0.5 * motion_.speed * random_.uniform(-1.0, 1.0);
    }
    scene.radius.push_back(random_.uniform(0.3, 0.7));
  }

  /// The last element takes its number.
  void remove(std::size_t k) {
    for (std::size_t axis = 0; axis < axes(); ++axis) take_last(coordinates(axis), k);
    take_last(scene.radius, k);
    take_last(velocity_, k);
  }

  /// Two elements change places.
  void exchange(std::size_t a, std::size_t b) {
    for (std::size_t axis = 0; axis < axes(); ++axis) {
      std::swap(coordinates(axis)[a], coordinates(axis)[b]);
    }
    std::swap(scene.radius[a], scene.radius[b]);
    std::swap(velocity_[a], velocity_[b]);
  }

  scenes::Scene scene;

 private:
  [[nodiscard]] std::size_t axes() const { return static_cast<std::size_t>(scene.dimensions); }
  std::vector<double>& coordinates(std::size_t axis) {
    return axis == 0 ? scene.x : axis == 1 ? scene.y : scene.z;
  }

  template <class T>
  static void take_last(std::vector<T>& values, std::size_t k) {
    values[k] = values.back();
    values.pop_back();
  }

  [[nodiscard]] Domain domain_2d(double l) const {
    switch (motion_.space) {
      case Space::slit:
        return Domain::periodic({l, unbounded});
      case Space::triclinic:
        return Domain::lattice({l, 0}, {-0.7 * l, l});
      case Space::swelling:
        return Domain::lattice({l * (1.0 + 0.0002 * time_), 0}, {0.2 * l, l});
      case Space::lees_edwards:
        return Domain::lees_edwards({l, l}, 0.013 * time_);
      default:
        return Domain::periodic({l, l});
    }
  }

  /// As simulation codes do: z first, then y with what the lattice is tilted by, then x.
  void wrap() {
    const Domain cell = domain();
    for (std::size_t axis = axes(); axis-- > 0;) {
      if (!cell.is_periodic(static_cast<int>(axis))) continue;
      const auto& vector = cell.vector(static_cast<int>(axis));
      for (std::size_t k = 0; k < scene.size(); ++k) {
        const double cells = std::floor(coordinates(axis)[k] / vector[axis]);
        for (std::size_t component = 0; component < axes() && cells != 0.0; ++component) {
          coordinates(component)[k] -= cells * vector[component];
        }
      }
    }
  }

  Motion motion_;
  scenes::Random random_;
  double side_ = 0.0;
  double time_ = 0.0;
  std::vector<std::array<double, 3>> velocity_;
};

}  // namespace abut::testing
