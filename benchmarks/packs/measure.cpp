#include "benchmarks/packs/measure.hpp"

#include "benchmarks/packs/verify.hpp"

#include <abut/error.hpp>

#include <algorithm>

namespace abut::benchmarks {
namespace {

Statistics detect(const ElementView& elements, Algorithm algorithm, Form form) {
  Options options;
  options.algorithm = algorithm;
  if (form == Form::count) return count_contact_pairs(elements, Domain::open(), options);
  options.order = form == Form::canonical ? Order::canonical : Order::as_found;
  return find_contact_pairs(elements, Domain::open(), options).statistics();
}

double minimum(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

/// One algorithm in one form, sample after sample.
class Contestant {
 public:
  Contestant(const AlgorithmInfo& info, Form form) {
    measurement_.contestant = &info;
    measurement_.form = form;
  }

  /// Warms up, notes a refusal, finds how many detections make a sample.
  void prepare(const ElementView& elements, double shortest_sample) {
    try {
      double spent = 0.0;
      std::size_t detections = 0;
      do {
        spent += processor_seconds([&] { measurement_.statistics = run(elements); });
        ++detections;
      } while (spent < shortest_sample);
      detections_a_sample_ = detections;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::limit_exceeded) throw;
      measurement_.refusal = error.what();
    }
  }

  void take_sample(const ElementView& elements) {
    if (!measurement_.refusal.empty()) return;
    const double sample = processor_seconds([&] {
      for (std::size_t k = 0; k < detections_a_sample_; ++k) {
        measurement_.statistics = run(elements);
      }
    });
    spent_ += sample;
    cpu_.push_back(sample / static_cast<double>(detections_a_sample_));
    gather_.push_back(measurement_.statistics.gather_seconds);
    search_.push_back(measurement_.statistics.search_seconds);
    order_.push_back(measurement_.statistics.order_seconds);
  }

  /// CPU time of all samples.
  [[nodiscard]] double spent() const noexcept { return spent_; }

  [[nodiscard]] Measurement result() {
    if (cpu_.empty()) return measurement_;
    measurement_.repetitions = cpu_.size();
    measurement_.cpu = median_and_minimum(cpu_);
    measurement_.gather = minimum(gather_);
    measurement_.search = minimum(search_);
    measurement_.order = minimum(order_);
    return measurement_;
  }

 private:
  Statistics run(const ElementView& elements) const {
    return detect(elements, measurement_.contestant->algorithm, measurement_.form);
  }

  Measurement measurement_;
  std::size_t detections_a_sample_ = 1;
  double spent_ = 0.0;
  std::vector<double> cpu_;
  std::vector<double> gather_;
  std::vector<double> search_;
  std::vector<double> order_;
};

}  // namespace

std::string_view name_of(Form form) {
  switch (form) {
    case Form::count:
      return "count";
    case Form::as_found:
      return "as_found";
    default:
      return "canonical";
  }
}

std::vector<Measurement> measure(const ElementView& elements, const Effort& effort) {
  std::vector<Contestant> contestants;
  for (const AlgorithmInfo& info : algorithms()) {
    if (!takes_part(info, elements.size())) continue;
    for (const Form form : forms) contestants.emplace_back(info, form);
  }
  for (Contestant& contestant : contestants) contestant.prepare(elements, effort.shortest_sample);

  const double share = effort.seconds / static_cast<double>(contestants.size());
  for (std::size_t round = 0; round < effort.most_repetitions; ++round) {
    for (Contestant& contestant : contestants) {
      if (round < effort.least_repetitions || contestant.spent() < share) {
        contestant.take_sample(elements);
      }
    }
  }
  std::vector<Measurement> results;
  for (Contestant& contestant : contestants) results.push_back(contestant.result());
  return results;
}

}  // namespace abut::benchmarks
