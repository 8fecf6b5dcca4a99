#include "benchmarks/device/device_row.hpp"

#include <cstdio>

namespace abut::benchmarks {

void print_heading() {
  std::puts(
      "contestant,scene,elements,pairs,answer,first_ms,median_ms,least_ms,ns_per_element,"
      "billions_per_second,of_compulsory_bytes,of_moved_bytes,times_the_processor,gather_ms,"
      "search_ms,order_ms,peak_bytes_per_element");
}

void print_row(const DeviceRow& row, const DeviceEffort& effort, double processor_seconds) {
  std::printf("%s,%s,%llu,%llu,%s,", row.contestant.c_str(), row.scene.c_str(),
              static_cast<unsigned long long>(row.elements),
              static_cast<unsigned long long>(row.pairs), row.is_right ? "right" : "WRONG");
  if (!row.is_right) {
    std::puts(",,,,,,,,,,,");
    return;
  }
  const auto n = static_cast<double>(row.elements);
  const double compulsory = 32.0 * n + 8.0 * static_cast<double>(row.pairs);
  std::printf("%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.2f,%.4f,%.4f,%.4f,%.1f\n", 1e3 * row.first,
              1e3 * row.median, 1e3 * row.least, 1e9 * row.median / n, 1e-9 * n / row.median,
              row.median * effort.copy_speed / compulsory,
              row.median * effort.copy_speed / (n * row.bytes_of_element),
              processor_seconds / row.median, 1e3 * row.gather, 1e3 * row.search, 1e3 * row.order,
              static_cast<double>(row.peak_bytes) / n);
  std::fflush(stdout);
}

}  // namespace abut::benchmarks
