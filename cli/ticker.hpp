#pragma once

#include "progress_display.hpp"

#include <condition_variable>
#include <mutex>
#include <string_view>
#include <thread>

namespace abut::cli {

/// Shows, as long as it lives, that work goes on which does not tell how far it is. Nothing else
/// may use the display meanwhile. Where the system grants no thread, nothing is shown.
class Ticker {
 public:
  Ticker(ProgressDisplay& display, std::string_view phase);
  ~Ticker();
  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;

 private:
  void tick();

  ProgressDisplay& display_;
  std::string_view phase_;
  std::mutex mutex_;
  std::condition_variable end_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace abut::cli
