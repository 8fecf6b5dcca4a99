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
  statistics.contact_pairs = answer.count;
  statistics.candidate_tests = answer.candidate_tests;
  statistics.exact_decisions = answer.exact_decisions;
  statistics.peak_bytes = answer.peak_bytes;
  return statistics;
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
  PairList list;

  /// Asks the backend through `call(request, max_bytes, progress)`.
  template <class Call>
  Backend::Answer answer(const SphereSets& spheres, const Domain& domain, Call&& call) const {
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
                                .lattice = elements::lattice_of(domain)},
                  max_bytes, progress);
    });
  }

  const PairList& find(const SphereSets& spheres, const Domain& domain, const Stream& stream);
  Statistics count(const SphereSets& spheres, const Domain& domain, const Stream& stream) const;
};

void PairList::wait() const {
  if (backend_ != nullptr) backend_->wait();
}

abut::PairList PairList::to_host() const {
  return base::reporting_lack_of_memory([&] {
    PairArray pairs(size());
    if (!empty()) backend_->copy_to_host(pairs.data(), pairs_, size());
    ShiftArray shifts(shifts_ == nullptr ? 0 : size());
    if (!shifts.empty()) backend_->copy_to_host(shifts.data(), shifts_, size());
    return abut::PairList(std::move(pairs), std::move(shifts), statistics_);
  });
}

Detector::Detector(Options options, Device device, Allocator allocator)
    : state_(std::make_unique<State>(State{
          std::move(options), open_backend(device.number, whole(std::move(allocator))), {}})) {
  state_->list.backend_ = state_->backend.get();
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
  list.pairs_ = nullptr;
  list.shifts_ = nullptr;
  list.statistics_ = {};
  const Backend::Answer found = answer(
      spheres, domain,
      [&](const DeviceRequest& request, std::uint64_t max_bytes, base::ProgressReporter& progress) {
        return backend->list(spheres, request, max_bytes, stream, progress);
      });
  list.pairs_ = found.pairs;
  list.shifts_ = found.shifts;
  list.statistics_ = statistics_of(found, spheres);
  return list;
}

Statistics Detector::State::count(const SphereSets& spheres, const Domain& domain,
                                  const Stream& stream) const {
  const Backend::Answer found = answer(
      spheres, domain,
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
