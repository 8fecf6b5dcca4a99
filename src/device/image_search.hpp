#pragma once

#include "device/bodies/images.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/size_class.hpp"
#include "device/cell_buffer.hpp"
#include "device/checked_elements.hpp"
#include "device/executor.hpp"
#include "device/image_plan.hpp"
#include "device/search/partner_search.hpp"
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

  ImageSearch(E& executor, const Given& elements, const Extent<Dim>& extent,
              const exact::Lattice& lattice, double margin)
      : executor_(executor), elements_(elements), plan_(Given::shape, lattice, extent, margin) {
    if (!plan_.has_images()) {
      spheres_.emplace(as_given());
      return;
    }
    if constexpr (Given::shape == Shape::sphere) {
      plan_.choose_size_cut(elements_.count,
                            [&] { return count_sizes(executor_, elements_, extent); });
    }
    plan_.take_extent_as_given(extent_in(plan_.cell_as_given(), as_given()));
    if (!plan_.is_in_range()) check_range(extent, margin);
    wrap();
    const lattice::GhostWindows<Dim> windows = find_windows();
    slack_ = plan_.slack(windows);
    list_ghosts(windows);
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
  /// What the search is asked for, in the unit of its spheres.
  [[nodiscard]] double margin() const noexcept { return plan_.margin(); }
  [[nodiscard]] double slack() const noexcept { return slack_; }

 private:
  [[nodiscard]] Spheres as_given() const {
    return {elements_, plan_.map_as_given(), {}, {}, elements_.count};
  }

  template <class Locals>
  [[nodiscard]] lattice::CellExtent<Dim> extent_in(const lattice::OrthogonalCell<Dim>& cell,
                                                   const Locals& locals) {
    return executor_.reduce(elements_.count, lattice::CellExtent<Dim>{},
                            PlaceInCell<Locals>{locals, cell}, JoinCellExtents{});
  }

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

  [[nodiscard]] lattice::GhostWindows<Dim> find_windows() {
    if (plan_.needs_extent_of_locals()) {
      const Spheres locals{
          elements_, plan_.map_of_locals(), cells_moved_.cells(), {}, elements_.count};
      plan_.take_extent_of_locals(extent_in(plan_.cell_of_locals(), locals));
    }
    return plan_.windows();
  }

  void list_ghosts(const lattice::GhostWindows<Dim>& windows) {
    spheres_.emplace(
        Spheres{elements_, plan_.map(windows), cells_moved_.cells(), {}, elements_.count});
    const std::uint64_t count = elements_.count;
    const Buffer<std::uint64_t, E> places(executor_, count + 1);
    executor_.for_each(
        count + 1, CountGhosts<Spheres>{*spheres_, windows, most_ghosts_of_one(), places.data()});
    const std::uint64_t ghosts = sum_before_each(executor_, places.data(), count);
    reach_is_long_ =
        static_cast<double>(ghosts) > lattice::ghosts_of_long_reach * static_cast<double>(count);
    if (reach_is_long_) return;
    require_countable(windows, ghosts);
    elements_of_ghosts_ = Buffer<std::uint32_t, E>(executor_, ghosts);
    images_ = CellBuffer<std::uint32_t, E>(executor_, ghosts, plan_.packing_of_images(windows));
    const PackedGhosts packed{elements_of_ghosts_.data(), images_.cells()};
    executor_.for_each(count, WriteGhosts<Spheres>{*spheres_, windows, places.data(), packed});
    spheres_->ghosts = packed;
    spheres_->count = static_cast<std::uint32_t>(count + ghosts);
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
  CellBuffer<std::uint64_t, E> cells_moved_;
  Buffer<std::uint32_t, E> elements_of_ghosts_;
  CellBuffer<std::uint32_t, E> images_;
  std::optional<Spheres> spheres_;
  double slack_ = 0.0;
  bool reach_is_long_ = false;
};

}  // namespace abut::device
