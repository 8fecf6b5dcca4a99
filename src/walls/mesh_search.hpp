#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "base/memory_meter.hpp"
#include "elements/sphere_reader.hpp"
#include "exact/box.hpp"
#include "exact/sphere.hpp"
#include "walls/feature_search.hpp"
#include "walls/grid/rest_frame.hpp"
#include "walls/grid/wall_grid.hpp"
#include "walls/grid/wall_planes.hpp"
#include "walls/mesh_toucher.hpp"

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/image_shift.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/options.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/statistics.hpp>
#include <abut/triangle_mesh.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::walls {

/// The arrays of a list of contacts with a mesh, to be filled.
struct MeshContactArrays {
  std::vector<MeshContact>& contacts;
  std::vector<ImageShift>& shifts;
  PairGeometry& geometry;
};

/// Finds contacts with a mesh again and again, in open space and without a rule. It keeps its
/// memory and a grid of the triangles, which it builds anew only when the mesh has other triangles,
/// when its rest position has changed too much, or when larger spheres come.
class MeshSearch {
 public:
  MeshSearch() = default;
  MeshSearch(const MeshSearch&) = delete;
  MeshSearch& operator=(const MeshSearch&) = delete;
  ~MeshSearch() = default;

  /// The contacts of find_mesh_contacts in open space. Needs the default floating-point
  /// environment. On failure the arrays hold anything.
  Statistics find(const ElementView& spheres, const TriangleMesh& mesh, const Options& options,
                  const MeshContactArrays& arrays);

  /// Number of times that the grid was built.
  [[nodiscard]] std::uint64_t builds() const noexcept { return builds_; }

 private:
  /// One call.
  struct Call {
    const ElementView& spheres;
    const TriangleMesh& mesh;
    const Options& options;
    base::DetectionContext& context;
    std::size_t workers;
  };

  /// Spheres that are read at a time.
  static constexpr std::size_t block_size = kernels::most_spheres;

  /// The memory of each worker.
  struct alignas(128) SearchScratch {
    explicit SearchScratch(base::MemoryMeter& memory)
        : found(memory),
          candidates(base::make_array_for_overwrite<ContactPair>(memory, 0)),
          parts(base::make_array_for_overwrite<std::uint8_t>(memory, 0)) {}

    void start_anew() noexcept {
      found.contacts.clear();
      found.exact_decisions = 0;
      tests = 0;
      largest_radius = 0.0;
    }
    FoundContacts<MeshContact> found;
    std::array<double, elements::SphereReader::numbers * block_size> room;
    std::array<std::uint32_t, block_size> near;
    std::array<std::uint32_t, block_size> kept;
    kernels::NearColumns columns;
    base::Array<ContactPair> candidates;  ///< of some spheres of a block, by the numbers in it
    base::Array<std::uint8_t> parts;      ///< of the candidates
    std::uint64_t tests = 0;
    double largest_radius = 0.0;
  };

  void find_all(const Call& call);
  [[nodiscard]] bool is_grid_of(const TriangleMesh& mesh) const noexcept;
  [[nodiscard]] RestFrame frame_of(const TriangleMesh& mesh) const noexcept;
  [[nodiscard]] bool reaches(const RestFrame& frame, const Call& call) const noexcept;
  [[nodiscard]] double reach_of(const Call& call) const noexcept;
  void build(const Call& call);
  void choose(const Call& call, const kernels::ElementColumns& block, std::size_t near,
              SearchScratch& scratch) const;
  [[nodiscard]] exact::Box<3> box_around(const TriangleMesh::Corners& corners) const noexcept;
  double search(const Call& call, const RestFrame& frame);
  template <class Act>
  void for_each_block(const Call& call, Act&& act);
  [[nodiscard]] double largest_radius(const Call& call);
  [[nodiscard]] double largest_of_workers(const Call& call) const noexcept;
  void write(const Call& call, const MeshContactArrays& arrays, Statistics& statistics);
  void measure(const Call& call, const MeshContactArrays& arrays, Statistics& statistics);

  base::MemoryMeter memory_;
  WallGrid grid_{memory_};
  double reach_of_grid_ = -1.0;      ///< < 0 while there is none
  double last_radius_ = 0.0;         ///< the largest of the last call
  bool is_anchored_at_rest_ = true;  ///< else where the mesh was moved to when the grid was built
  base::Array<TriangleMesh::Point> anchor_ =
      base::make_array_for_overwrite<TriangleMesh::Point>(memory_, 0);
  base::Array<TriangleMesh::Corners> triangles_ =
      base::make_array_for_overwrite<TriangleMesh::Corners>(memory_, 0);
  WallPlanes planes_{memory_};
  std::vector<SearchScratch> scratch_;
  std::uint64_t builds_ = 0;
};

}  // namespace abut::walls
