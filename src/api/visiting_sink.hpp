#pragma once

#include "base/callers_exception.hpp"
#include "base/pair_sink.hpp"

#include <abut/detect.hpp>
#include <abut/error.hpp>
#include <abut/pair.hpp>

#include <span>
#include <string>

namespace abut::api {

/// Hands pairs to the caller's visitor, or only counts them.
class VisitingSink final : public base::PairSink {
 public:
  VisitingSink(PairCount limit, const PairBatchVisitor* visitor)
      : limit_(limit), visitor_(visitor) {}

  PairCount count = 0;

 private:
  void receive(std::span<const ContactPair> found) override {
    if (found.size() > limit_ - count) {
      throw Error(ErrorCode::limit_exceeded,
                  "there are more than " + std::to_string(limit_) +
                      " contact pairs, the limit that was set; raise it");
    }
    count += found.size();
    if (visitor_ != nullptr) base::call_back([&] { (*visitor_)(found, 0); });
  }

  PairCount limit_;
  const PairBatchVisitor* visitor_;
};

}  // namespace abut::api
