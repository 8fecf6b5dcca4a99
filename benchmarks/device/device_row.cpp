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
  std::printf("%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,", 1e3 * row.first, 1e3 * row.median, 1e3 * row.least,
              1e9 * row.median / n, 1e-9 * n / row.median,
              row.median * effort.copy_speed / row.compulsory_bytes);
  if (row.moved_bytes) std::printf("%.4f", row.median * effort.copy_speed / *row.moved_bytes);
  std::printf(",");
  if (processor_seconds > 0.0) std::printf("%.2f", processor_seconds / row.median);
  std::printf(",%.4f,%.4f,%.4f,%.1f\n", 1e3 * row.gather, 1e3 * row.search, 1e3 * row.order,
              static_cast<double>(row.peak_bytes) / n);
  std::fflush(stdout);
}

}  // namespace abut::benchmarks
