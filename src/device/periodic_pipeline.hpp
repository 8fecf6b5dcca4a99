#pragma once

#include "base/progress_reporter.hpp"
#include "device/bodies/name_pair.hpp"
#include "device/checked_elements.hpp"
#include "device/detection.hpp"
#include "device/detection_by_pairs.hpp"
#include "device/device_request.hpp"
#include "device/domain_numbers.hpp"
#include "device/executor.hpp"
#include "device/finish_list.hpp"
#include "device/found_list.hpp"
#include "device/image_plan.hpp"
#include "device/image_search.hpp"
#include "device/rule_arrays.hpp"

#include <abut/error.hpp>
#include <abut/image_shift.hpp>
#include <abut/options.hpp>

#include <exception>
#include <optional>
#include <string>

namespace abut::device {

/// One detection of spheres in a periodic domain, or of two sets or by a rule in any, or of boxes
/// (`Given` is Joined of some columns): the stages of Pipeline among locals and ghosts, whose pairs
/// are named by elements and shifts then. One wait more in a periodic domain, for the numbers of
/// ghosts, and one where elements lie outside the cell, for where they lie in it. It is compiled
/// for `float` and `double` together.
template <class Given, class E>
class PeriodicPipeline {
  static constexpr int Dim = Given::dimensions;

 public:
  PeriodicPipeline(E& executor, const Given& elements, const DeviceRequest& request,
                   base::ProgressReporter& progress)
      : executor_(executor), elements_(elements), request_(request), progress_(progress) {}

  /// All contact pairs, in canonical order, in the form that is asked for.
  [[nodiscard]] FoundList<E> list() {
    FoundList<E> found;
    detect([&](auto& detection) {
      detection.list(found);
      name(detection.spheres(), found);
    });
    finish_list(executor_, elements_, elements_.first.count, request_, progress_, found);
    return found;
  }

  /// Their number.
  [[nodiscard]] FoundList<E> count() {
    FoundList<E> found;
    detect([&](auto& detection) { detection.count(found); });
    return found;
  }

 private:
  using Images = ImageSearch<Given, E>;
  using Spheres = typename Images::Spheres;

  /// The search numbers the elements of both sets as one, and so do its messages.
  template <class Use>
  void detect(Use&& use) {
    progress_.begin("gather", elements_.count);
    if (elements_.count == 0) return require_lattice();
    RuleArrays<E> rule(executor_, request_.rule, elements_);
    std::optional<ImagePlan<Dim>> plan;
    std::exception_ptr refusal;
    try {
      plan.emplace(Given::shape, request_.lattice, request_.margin);
    } catch (const Error&) {
      refusal = std::current_exception();
    }
    const DomainNumbers<Dim> numbers = numbers_of_elements(rule, plan);
    rule.require_groups(numbers.missing_group);
    require_valid(executor_, elements_, numbers.overview.all);
    try {
      if (refusal) std::rethrow_exception(refusal);
      search(*plan, numbers, rule.view(), use);
    } catch (const Error& error) {
      if (!elements_.is_of_two_sets || error.code() != ErrorCode::invalid_input) throw;
      throw Error(error.code(),
                  std::string(error.what()) + " (the elements of the second set are counted from " +
                      std::to_string(elements_.first.count) + " on, behind those of the first)");
    }
  }

  /// Waits: what is refused is told before anything is done with it, elements before a lattice for
  /// which there is no plan; levels, cells and images follow the rest.
  [[nodiscard]] DomainNumbers<Dim> numbers_of_elements(RuleArrays<E>& rule,
                                                       const std::optional<ImagePlan<Dim>>& plan) {
    const Buffer<DomainNumbers<Dim>, E> on_device(executor_, 1);
    DomainNumbers<Dim>* const target = on_device.data();
    executor_.for_each(1, ClearDomainNumbers<Dim>{target});
    write_overview(executor_, elements_, &target->overview);
    rule.find_missing_group(&target->missing_group);
    if (plan && plan->has_images()) {
      Images::write_extent_in_cell(executor_, elements_, *plan, &target->in_cell);
    }
    DomainNumbers<Dim> numbers;
    executor_.copy_to_host(&numbers, target, 1);
    return numbers;
  }

  template <class Use>
  void search(const ImagePlan<Dim>& plan, const DomainNumbers<Dim>& numbers, const RuleView& rule,
              Use&& use) {
    const Images images(executor_, elements_, plan, numbers, request_.margin);
    if (images.reach_is_long()) return check_pairs(images, rule, use);
    Spheres spheres = images.spheres();
    spheres.rule = rule;
    progress_.begin("search", spheres.count);
    Detection<Spheres, E> detection(
        executor_, spheres, images.overview(), request_,
        {images.margin(), images.slack(), request_.items_at_a_time, request_.narrow_places});
    use(detection);
  }

  template <class Use>
  void check_pairs(const Images& images, const RuleView& rule, Use&& use) {
    CheckedElements<Given> elements = images.checked_elements();
    elements.rule = rule;
    progress_.begin("search", elements.count);
    DetectionByPairs<CheckedElements<Given>, E> check(
        executor_, elements, images.windows_of_pairs(), images.margin_of_checks(), request_);
    use(check);
  }

  /// A lattice that cannot be reduced is refused also where it holds nothing.
  void require_lattice() const {
    static_cast<void>(ImagePlan<Dim>(Given::shape, request_.lattice, request_.margin));
  }

  template <class Elements>
  void name(const Elements& spheres, FoundList<E>& found) {
    if (request_.finds_shifts(Dim)) {
      found.shifts = Buffer<ImageShift, E>(executor_, found.count);
    }
    executor_.for_each(found.count,
                       NamePair<Elements>{spheres, found.pairs.data(), found.shifts.data()});
  }

  E& executor_;
  Given elements_;
  DeviceRequest request_;
  base::ProgressReporter& progress_;
};

}  // namespace abut::device
