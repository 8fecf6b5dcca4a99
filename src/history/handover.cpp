#include "history/handover.hpp"

#include "elements/gathered_elements.hpp"
#include "elements/lattice_of.hpp"
#include "lattice/lattice_frame.hpp"
#include "walls/feature_measurer.hpp"

#include <abut/quantity.hpp>

#include <algorithm>
#include <array>
#include <compare>
#include <optional>
#include <tuple>

namespace abut::history {
namespace {

/// Cosine of 60 degrees: less than that is no smooth surface.
constexpr double least_agreement = 0.5;

/// Where the vertices of features lie, by the numbers of the vertices that they were joined to.
class Corners {
 public:
  explicit Corners(const TriangleMesh& mesh) : mesh_(mesh) {
    if (!mesh.feature_shifts().empty()) frame_.emplace(elements::lattice_of(mesh.domain()));
  }

  /// Calls act(place) for each vertex of a feature.
  template <class Act>
  void for_each(const walls::MovedFeature& moved, Act&& act) const {
    const auto each = [&](const auto& vertices) {
      for (const ElementIndex vertex : vertices) act(place_of(vertex, moved.shift));
    };
    const ElementIndex number = moved.feature.number;
    switch (moved.feature.kind) {
      case FeatureKind::vertex:
        return each(std::array<ElementIndex, 1>{number});
      case FeatureKind::edge:
        return each(mesh_.edges()[number]);
      default:
        return each(mesh_.triangles()[number]);
    }
  }

 private:
  /// A vertex that was joined across faces of the domain lies a lattice vector from the one that it
  /// was joined to, exactly: the nearest lattice vector is that one, whatever rounding did.
  [[nodiscard]] walls::VertexPlace place_of(ElementIndex vertex, const ImageShift& shift) const {
    const ElementIndex joined = mesh_.vertex_features()[vertex];
    if (!frame_ || joined == vertex) return {joined, shift};
    std::array<double, 3> difference{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      difference[axis] = mesh_.vertices()[vertex][axis] - mesh_.vertices()[joined][axis];
    }
    lattice::CellNumbers cells{};
    (void)frame_->nearest(difference.data(), cells);
    return {joined, sum_of(shift, {cells[0], cells[1], cells[2]})};
  }

  const TriangleMesh& mesh_;
  std::optional<lattice::LatticeFrame<3>> frame_;
};

/// Cosine of the angle between the directions from a sphere to two features; 0 if its center lies
/// on one.
class Agreement {
 public:
  Agreement(const ElementView& spheres, const TriangleMesh& mesh, const Domain& domain)
      : spheres_(spheres), measurer_(mesh, domain) {}

  [[nodiscard]] double operator()(const WallKey& one, const WallKey& other) const {
    const exact::Sphere<3> sphere = elements::sphere_at<3>(spheres_, one.sphere);
    const auto normal_to = [&](const WallKey& key) {
      return measurer_(sphere, {key.sphere, key.wall.feature}, key.wall.shift, Quantity::normal)
          .normal;
    };
    const auto a = normal_to(one), b = normal_to(other);
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
  }

 private:
  const ElementView& spheres_;
  walls::FeatureMeasurer measurer_;
};

}  // namespace

/// Candidates: all pairs of one sphere whose features have a vertex in common, each once.
void Handover::find_connected(std::span<const WallKey> born, std::span<const WallKey> gone,
                              const TriangleMesh& mesh) {
  corners_.clear();
  candidates_.clear();
  const Corners corners(mesh);
  const auto key_of = [](const ContactCorner& c) { return std::tie(c.sphere, c.vertex); };
  for (std::size_t g = 0; g < gone.size(); ++g) {
    corners.for_each(gone[g].wall, [&](const walls::VertexPlace& vertex) {
      corners_.push_back({gone[g].sphere, vertex, g});
    });
  }
  std::sort(corners_.begin(), corners_.end(),
            [&](const ContactCorner& a, const ContactCorner& b) { return key_of(a) < key_of(b); });
  for (std::size_t k = 0; k < born.size(); ++k) {
    corners.for_each(born[k].wall, [&](const walls::VertexPlace& vertex) {
      const auto wanted = std::tie(born[k].sphere, vertex);
      auto corner =
          std::partition_point(corners_.begin(), corners_.end(),
                               [&](const ContactCorner& c) { return key_of(c) < wanted; });
      for (; corner != corners_.end() && key_of(*corner) == wanted; ++corner) {
        candidates_.push_back({{k, corner->gone}, 0.0});
      }
    });
  }
  const auto places = [](const Candidate& c) { return std::tie(c.pair.born, c.pair.gone); };
  std::sort(candidates_.begin(), candidates_.end(),
            [&](const Candidate& a, const Candidate& b) { return places(a) < places(b); });
  const auto end =
      std::unique(candidates_.begin(), candidates_.end(),
                  [&](const Candidate& a, const Candidate& b) { return places(a) == places(b); });
  candidates_.erase(end, candidates_.end());
}

/// Takes the candidates one after the other, as far as both are free.
void Handover::choose(std::size_t born, std::size_t gone) {
  born_taken_.assign(born, false);
  gone_taken_.assign(gone, false);
  for (const auto& [pair, agreement] : candidates_) {
    if (born_taken_[pair.born] || gone_taken_[pair.gone]) continue;
    born_taken_[pair.born] = gone_taken_[pair.gone] = true;
    pairs_.push_back(pair);
  }
}

std::span<const Handover::Pair> Handover::find(std::span<const WallKey> born,
                                               std::span<const WallKey> gone,
                                               const ElementView& spheres, const TriangleMesh& mesh,
                                               const Domain& domain) {
  pairs_.clear();
  if (born.empty() || gone.empty()) return pairs_;
  find_connected(born, gone, mesh);
  const Agreement agreement(spheres, mesh, domain);
  for (Candidate& c : candidates_) c.agreement = agreement(born[c.pair.born], gone[c.pair.gone]);
  std::erase_if(candidates_, [](const Candidate& c) { return !(c.agreement > least_agreement); });
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
    if (a.agreement != b.agreement) return a.agreement > b.agreement;
    return std::tie(a.pair.born, a.pair.gone) < std::tie(b.pair.born, b.pair.gone);
  });
  choose(born.size(), gone.size());
  return pairs_;
}

}  // namespace abut::history
