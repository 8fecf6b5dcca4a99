#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/progress_reporter.hpp"
#include "device/backend.hpp"
#include "device/validate_request.hpp"
#include "elements/lattice_of.hpp"

#include <abut/device.hpp>
#include <abut/error.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace abut::device {
namespace {

Statistics statistics_of(const Backend::Answer& answer, const SphereSets& spheres) {
  Statistics statistics;
  statistics.algorithm = Algorithm::rows;
  statistics.reason = "the algorithm of devices";
  statistics.elements = spheres.first.size();
  if (spheres.second != nullptr) statistics.elements += spheres.second->size();
  statistics.dimensions = spheres.first.dimensions();
  statistics.contact_pairs = answer.contact_pairs;
  statistics.candidate_tests = answer.candidate_tests;
  statistics.exact_decisions = answer.exact_decisions;
  statistics.peak_bytes = answer.peak_bytes;
  return statistics;
}

/// A copy of an array of the device; none of an array that is not there.
template <class Array>
Array copied(Backend* backend, const typename Array::value_type* source, std::size_t size) {
  Array array(source == nullptr ? 0 : size);
  if (!array.empty()) {
    backend->copy_to_host(array.data(), source, array.size() * sizeof(array[0]));
  }
  return array;
}

Allocator whole(Allocator allocator) {
  if (static_cast<bool>(allocator.allocate) == static_cast<bool>(allocator.release)) {
    return allocator;
  }
  throw Error(ErrorCode::wrong_usage,
              "an allocator of a device has one of its two functions only; give both or none");
}

}  // namespace

struct Detector::State {
  Options options;
  std::unique_ptr<Backend> backend;
  PairList pairs = {};
  NeighborList neighbors = {};

  /// Asks the backend through `call(request, max_bytes, progress)`. The last list goes first.
  template <class Call>
  Backend::Answer answer(const SphereSets& spheres, const Domain& domain, ListForm form,
                         Call&& call) {
    forget();
    const base::FloatEnvironment environment;
    return base::reporting_lack_of_memory([&] {
      validate_request(options, spheres, domain);
      base::ProgressReporter progress(options.progress);
      const std::uint64_t max_bytes = options.max_bytes == automatic_memory_bound
                                          ? std::numeric_limits<std::uint64_t>::max()
                                          : options.max_bytes;
      return call(DeviceRequest{.margin = options.margin,
                                .max_pairs = options.max_pairs,
                                .shifts = options.shifts,
                                .form = form,
                                .quantities = options.quantities,
                                .lattice = elements::lattice_of(domain),
                                .rule = options.rule},
                  max_bytes, progress);
    });
  }

  const PairList& find(const SphereSets& spheres, const Domain& domain, const Stream& stream);
  const NeighborList& build(const SphereSets& spheres, const Domain& domain, ListForm form,
                            const Stream& stream);
  Statistics count(const SphereSets& spheres, const Domain& domain, const Stream& stream);

  Backend::Answer list(const SphereSets& spheres, const Domain& domain, ListForm form,
                       const Stream& stream);

  /// Empties the lists.
  void forget() noexcept {
    pairs = {};
    neighbors = {};
    pairs.backend_ = neighbors.backend_ = backend.get();
  }
};

void PairList::wait() const {
  if (backend_ != nullptr) backend_->wait();
}

abut::PairList PairList::to_host() const {
  return base::reporting_lack_of_memory([&] {
    PairGeometry geometry;
    geometry.gaps = copied<NumberArray>(backend_, gaps_, size());
    return abut::PairList(copied<PairArray>(backend_, pairs_, size()),
                          copied<ShiftArray>(backend_, shifts_, size()), std::move(geometry),
                          statistics_);
  });
}

void NeighborList::wait() const {
  if (backend_ != nullptr) backend_->wait();
}

abut::NeighborList NeighborList::to_host() const {
  using Rows = abut::NeighborList;
  return base::reporting_lack_of_memory([&] {
    PairGeometry geometry;
    geometry.gaps = copied<NumberArray>(backend_, gaps_, neighbor_count_);
    return Rows(copied<Rows::Offsets>(backend_, offsets_, rows_ + 1),
                copied<Rows::Neighbors>(backend_, neighbors_, neighbor_count_),
                copied<ShiftArray>(backend_, shifts_, neighbor_count_), std::move(geometry),
                statistics_);
  });
}

Detector::Detector(Options options, Device device, Allocator allocator)
    : state_(std::make_unique<State>(
          State{std::move(options), open_backend(device.number, whole(std::move(allocator)))})) {
  state_->forget();
}

Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const Options& Detector::options() const noexcept {
  return state_->options;
}

void Detector::set_options(Options options) {
  state_->options = std::move(options);
}

const PairList& Detector::State::find(const SphereSets& spheres, const Domain& domain,
                                      const Stream& stream) {
  const Backend::Answer found = list(spheres, domain, ListForm::pairs, stream);
  pairs.pairs_ = found.pairs;
  pairs.shifts_ = found.shifts;
  pairs.gaps_ = found.gaps;
  pairs.statistics_ = statistics_of(found, spheres);
  return pairs;
}

const NeighborList& Detector::State::build(const SphereSets& spheres, const Domain& domain,
                                           ListForm form, const Stream& stream) {
  const Backend::Answer found = list(spheres, domain, form, stream);
  neighbors.rows_ = spheres.first.size();
  neighbors.offsets_ = found.offsets;
  neighbors.neighbors_ = found.neighbors;
  neighbors.shifts_ = found.shifts;
  neighbors.gaps_ = found.gaps;
  neighbors.neighbor_count_ = found.entries;
  neighbors.statistics_ = statistics_of(found, spheres);
  return neighbors;
}

Backend::Answer Detector::State::list(const SphereSets& spheres, const Domain& domain,
                                      ListForm form, const Stream& stream) {
  return answer(
      spheres, domain, form,
      [&](const DeviceRequest& request, std::uint64_t max_bytes, base::ProgressReporter& progress) {
        return backend->list(spheres, request, max_bytes, stream, progress);
      });
}

Statistics Detector::State::count(const SphereSets& spheres, const Domain& domain,
                                  const Stream& stream) {
  const Backend::Answer found = answer(
      spheres, domain, ListForm::pairs,
      [&](const DeviceRequest& request, std::uint64_t max_bytes, base::ProgressReporter& progress) {
        return backend->count(spheres, request, max_bytes, stream, progress);
      });
  return statistics_of(found, spheres);
}

const PairList& Detector::find_contact_pairs(const ElementView& elements, const Domain& domain,
                                             Stream stream) {
  return state_->find({elements}, domain, stream);
}

const PairList& Detector::find_contact_pairs(const ElementView& first, const ElementView& second,
                                             const Domain& domain, Stream stream) {
  return state_->find({first, &second}, domain, stream);
}

const NeighborList& Detector::build_neighbor_list(const ElementView& elements, const Domain& domain,
                                                  NeighborListKind kind, Stream stream) {
  const ListForm form = kind == NeighborListKind::full ? ListForm::full_rows : ListForm::half_rows;
  return state_->build({elements}, domain, form, stream);
}

const NeighborList& Detector::build_neighbor_list(const ElementView& first,
                                                  const ElementView& second, const Domain& domain,
                                                  Stream stream) {
  return state_->build({first, &second}, domain, ListForm::half_rows, stream);
}

Statistics Detector::count_contact_pairs(const ElementView& elements, const Domain& domain,
                                         Stream stream) {
  return state_->count({elements}, domain, stream);
}

Statistics Detector::count_contact_pairs(const ElementView& first, const ElementView& second,
                                         const Domain& domain, Stream stream) {
  return state_->count({first, &second}, domain, stream);
}

std::vector<DeviceInfo> devices() {
  return base::reporting_lack_of_memory([] { return found_devices(); });
}

}  // namespace abut::device
