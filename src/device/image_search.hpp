#pragma once

#include "device/bodies/directory.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/periodic/ghosts.hpp"
#include "device/bodies/periodic/images.hpp"
#include "device/bodies/size_class.hpp"
#include "device/cell_buffer.hpp"
#include "device/checked_elements.hpp"
#include "device/domain_numbers.hpp"
#include "device/executor.hpp"
#include "device/image_plan.hpp"
#include "lattice/check_range.hpp"
#include "lattice/ghost_windows.hpp"
#include "lattice/image_window.hpp"
#include "lattice/orthogonal_cell.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace abut::device {

/// The locals and ghosts of elements in a periodic domain: counted, then written. They live as long
/// as this. In an open domain there are no ghosts.
template <class Given, class E>
class ImageSearch {
  static constexpr int Dim = Given::dimensions;

 public:
  using Spheres = PeriodicElements<Given>;

  /// Takes the numbers of the elements as they are given, and a plan that has not seen them yet.
  ImageSearch(E& executor, const Given& elements, const ImagePlan<Dim>& plan,
              const DomainNumbers<Dim>& numbers, double margin)
      : executor_(executor), elements_(elements), plan_(plan), overview_(numbers.overview) {
    plan_.take_extent(overview_.all);
    if (!plan_.has_images()) {
      spheres_.emplace(Spheres{elements_, plan_.map_as_given(), {}, {}, elements_.count});
      return;
    }
    if constexpr (Given::shape == Shape::sphere) {
      plan_.choose_size_cut(elements_.count, counts_of(overview_));
    }
    plan_.take_extent_in_cell(numbers.in_cell);
    if (!plan_.is_in_range()) check_range(overview_.all, margin);
    wrap();
    const lattice::GhostWindows<Dim> windows = find_windows();
    slack_ = plan_.slack(windows);
    list_ghosts(windows);
  }

  /// Writes the extent of the elements in the cell of a periodic domain to memory of the device.
  /// Waits for nothing.
  static void write_extent_in_cell(E& executor, const Given& elements, const ImagePlan<Dim>& plan,
                                   lattice::CellExtent<Dim>* extent) {
    const Spheres as_given{elements, plan.map_as_given(), {}, {}, elements.count};
    executor.reduce_into(extent, elements.count, lattice::CellExtent<Dim>{},
                         PlaceInCell<Spheres>{as_given, plan.cell_as_given()}, JoinCellExtents{});
  }

  /// True if the reach is about as long as the cell or longer, so that there are far more images
  /// than elements. Nothing is listed then: pairs are to be checked one by one.
  [[nodiscard]] bool reach_is_long() const noexcept { return reach_is_long_; }
  [[nodiscard]] CheckedElements<Given> checked_elements() const {
    return {elements_, plan_.map_of_basis(), {}, {}, elements_.count};
  }
  [[nodiscard]] lattice::ImageWindows<Dim> windows_of_pairs() const {
    return lattice::ImageWindows<Dim>(plan_.reduced(), plan_.unit_of_checks());
  }
  [[nodiscard]] double margin_of_checks() const noexcept { return plan_.margin_of_checks(); }

  [[nodiscard]] const Spheres& spheres() const noexcept { return *spheres_; }
  [[nodiscard]] const Overview<Dim>& overview() const noexcept { return overview_; }
  /// What the search is asked for, in the unit of its spheres.
  [[nodiscard]] double margin() const noexcept { return plan_.margin(); }
  [[nodiscard]] double slack() const noexcept { return slack_; }

 private:
  using Ghosts = GhostsOfLocals<Spheres>;

  /// Throws what lattice::check_range throws, and what wrapping throws.
  void check_range(const Extent<Dim>& extent, double margin) {
    for (const lattice::Wrapper<Dim>& wrapper : {plan_.wrapper_of_all(), plan_.wrapper()}) {
      const std::uint32_t far = executor_.reduce(
          elements_.count, no_element,
          FarElement<Given>{{elements_, wrapper, plan_.given_unit(), {}}}, Smaller{});
      if (far == no_element) continue;
      exact::Sphere<Dim> sphere = stand_in(whole_on_host(executor_, elements_, far));
      for (double& x : sphere.center) x *= plan_.given_unit();
      static_cast<void>(wrapper.wrap(sphere, far));
    }
    const std::uint32_t largest =
        executor_.reduce(elements_.count, no_element,
                         ElementOfRadius<Given>{elements_, extent.largest_radius}, Smaller{});
    lattice::check_reach<Dim>(largest, extent.largest_radius, plan_.reduced(), margin, Given::shape,
                              plan_.given_unit());
  }

  void wrap() {
    if (!plan_.moves_any()) return;
    cells_moved_ =
        CellBuffer<std::uint64_t, E>(executor_, elements_.count, plan_.packing_of_cells_moved());
    executor_.for_each(
        elements_.count,
        WrapElement<Given>{elements_, plan_.wrapper(), plan_.given_unit(), cells_moved_.cells()});
  }

  /// Waits where elements were moved: which images are ghosts follows where they are now.
  [[nodiscard]] lattice::GhostWindows<Dim> find_windows() {
    if (plan_.needs_extent_of_locals()) {
      const Spheres locals{
          elements_, plan_.map_of_locals(), cells_moved_.cells(), {}, elements_.count};
      plan_.take_extent_of_locals(executor_.reduce(
          elements_.count, lattice::CellExtent<Dim>{},
          PlaceInCell<Spheres>{locals, plan_.cell_of_locals()}, JoinCellExtents{}));
    }
    return plan_.windows();
  }

  void list_ghosts(const lattice::GhostWindows<Dim>& windows) {
    spheres_.emplace(
        Spheres{elements_, plan_.map(windows), cells_moved_.cells(), {}, elements_.count});
    const std::uint64_t count = elements_.count;
    const Ghosts of_locals{*spheres_, windows};
    const Buffer<std::uint64_t, E> places(executor_, count + 1);
    const std::uint64_t ghosts = count_ghosts(of_locals, places.data());
    reach_is_long_ =
        static_cast<double>(ghosts) > lattice::ghosts_of_long_reach * static_cast<double>(count);
    if (reach_is_long_) return;
    require_countable(windows, ghosts);
    elements_of_ghosts_ = Buffer<std::uint32_t, E>(executor_, ghosts);
    images_ = CellBuffer<std::uint32_t, E>(executor_, ghosts, plan_.packing_of_images(windows));
    const PackedGhosts packed{elements_of_ghosts_.data(), images_.cells()};
    executor_.for_each(count, WriteGhosts<Spheres>{of_locals, places.data(), packed});
    spheres_->ghosts = packed;
    spheres_->count = static_cast<std::uint32_t>(count + ghosts);
  }

  /// Finds the places of the ghosts of each element, and the overview of locals and ghosts. Waits:
  /// they need memory, and levels and cells.
  [[nodiscard]] std::uint64_t count_ghosts(const Ghosts& of_locals, std::uint64_t* places) {
    const std::uint64_t count = elements_.count;
    const std::uint64_t most = most_ghosts_of_one();
    executor_.for_each(count + 1, CountGhosts<Spheres>{of_locals, most, places});
    executor_.exclusive_scan(places, count + 1);
    const Buffer<GhostNumbers<Dim>, E> on_device(executor_, 1);
    Overview<Dim>* const overview = &on_device.data()->overview;
    executor_.for_each(1, CopyEntry<std::uint64_t>{places + count, &on_device.data()->ghosts});
    executor_.reduce_into(&overview->all, count, Extent<Dim>::of_none(),
                          ExtentWithGhosts<Spheres>{of_locals, most}, JoinExtents{});
    const bool is_of_one_size = !(overview_.all.smallest_radius < overview_.all.largest_radius);
    executor_.join_by_class(overview->classes, is_of_one_size ? 0 : count,
                            SizeClassWithGhosts<Spheres>{of_locals, most, &overview->all});
    GhostNumbers<Dim> numbers;
    executor_.copy_to_host(&numbers, on_device.data(), 1);
    overview_ = numbers.overview;
    return numbers.ghosts;
  }

  /// If one element has more, the reach is long, or there are too many, whatever the others have;
  /// and the sum of all has 64 bits.
  [[nodiscard]] std::uint64_t most_ghosts_of_one() const noexcept {
    return std::min(static_cast<std::uint64_t>(lattice::ghosts_of_long_reach) * elements_.count + 1,
                    std::uint64_t{1} << 32);
  }

  void require_countable(const lattice::GhostWindows<Dim>& windows, std::uint64_t ghosts) const {
    bool few = static_cast<double>(elements_.count) + static_cast<double>(ghosts) <=
               lattice::most_locals_and_ghosts;
    for (std::size_t side = 0; side < windows.of_large.sides(); ++side) {
      few = few && windows.of_large.most_cells(side) <= lattice::most_cells_away;
    }
    if (!few) lattice::refuse_number_of_images();
  }

  E& executor_;
  Given elements_;
  ImagePlan<Dim> plan_;
  Overview<Dim> overview_;  ///< of the elements, then of locals and ghosts
  CellBuffer<std::uint64_t, E> cells_moved_;
  Buffer<std::uint32_t, E> elements_of_ghosts_;
  CellBuffer<std::uint32_t, E> images_;
  std::optional<Spheres> spheres_;
  double slack_ = 0.0;
  bool reach_is_long_ = false;
};

}  // namespace abut::device
