#pragma once

#include <abut/pair.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace abut::base {

/// Where found pairs go: a small buffer that is handed on when it is full. `finish` hands on the
/// rest; pairs still in the buffer when a detection fails are dropped with it.
class PairSink {
 public:
  virtual ~PairSink() = default;

  void push(ContactPair pair) {
    buffer_[filled_++] = pair;
    if (filled_ == buffer_.size()) finish();
  }

  void finish() {
    const std::size_t count = filled_;
    filled_ = 0;
    if (count > 0) receive(std::span(buffer_).first(count));
  }

 protected:
  PairSink() = default;
  PairSink(const PairSink&) = default;
  PairSink& operator=(const PairSink&) = default;

 private:
  virtual void receive(std::span<const ContactPair> pairs) = 0;

  std::array<ContactPair, 1024> buffer_;
  std::size_t filled_ = 0;
};

}  // namespace abut::base
