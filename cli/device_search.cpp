#include "device_search.hpp"

#include <fmt/format.h>

#include <utility>

namespace abut::cli {
namespace {

Options with_rule(Options options, const PairRule& rule) {
  options.rule = rule;
  return options;
}

}  // namespace

void require_device(int device) {
  in_words_of_tool([&] { return device::Detector({}, device::on(device)); });
}

std::string device_text(int device) {
  for (const device::DeviceInfo& info : device::devices()) {
    if (info.number == device) return fmt::format("gpu:{}, {}", device, info.name);
  }
  return fmt::format("gpu:{}", device);
}

Error in_words_of_tool(const Error& error) {
  if (error.code() != ErrorCode::unavailable && error.code() != ErrorCode::wrong_usage) {
    return error;
  }
  const std::string sentence = error.what();
  return {error.code(),
          fmt::format("{}; leave out --device", sentence.substr(0, sentence.find(';')))};
}

DeviceSearch::DeviceSearch(int device, const ElementView& elements, const ElementView* others,
                           const Options& options)
    : copy_(elements, device::on(device)),
      rule_(options.rule, device::on(device)),
      detector_(with_rule(options, rule_.rule()), device::on(device)) {
  if (others != nullptr) partners_.emplace(*others, device::on(device));
}

void DeviceSearch::set_progress(ProgressHook hook) {
  Options options = detector_.options();
  options.progress = std::move(hook);
  detector_.set_options(std::move(options));
}

const device::PairList& DeviceSearch::find(const Domain& domain) {
  const device::PairList& pairs =
      partners_ ? detector_.find_contact_pairs(copy_.elements(), partners_->elements(), domain)
                : detector_.find_contact_pairs(copy_.elements(), domain);
  pairs.wait();
  return pairs;
}

NeighborList DeviceSearch::neighbors(const Domain& domain, NeighborListKind kind) {
  if (!partners_) return detector_.build_neighbor_list(copy_.elements(), domain, kind).to_host();
  return detector_.build_neighbor_list(copy_.elements(), partners_->elements(), domain).to_host();
}

Statistics DeviceSearch::count(const Domain& domain) {
  if (!partners_) return detector_.count_contact_pairs(copy_.elements(), domain);
  return detector_.count_contact_pairs(copy_.elements(), partners_->elements(), domain);
}

}  // namespace abut::cli
