// What must not compile, a mistake a CASE, and its right form: CASE 0.

#include <abut/abut.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#if CASE == 0
void all_right(double* x, double (*points)[3], std::size_t n, std::vector<float>& single,
               std::vector<std::array<float, 3>>& single_points) {
  static_cast<void>(abut::spheres(std::span(x, n), std::span(x, n), std::span(x, n), 0.5));
  static_cast<void>(abut::spheres(std::span(points, n), std::span(x, n)));
  static_cast<void>(abut::discs(single, single, single));
  static_cast<void>(abut::spheres(single_points, 0.5));
}
#elif CASE == 1
void pointers(double* x) {
  static_cast<void>(abut::spheres(x, x, x, 0.5));
}
#elif CASE == 2
void pointers(double (*points)[3]) {
  static_cast<void>(abut::spheres(points, 0.5));
}
#elif CASE == 3
void pointers(std::vector<double>& x, const double* r) {
  static_cast<void>(abut::discs(x, x, r));
}
#elif CASE == 4
void pointers(float* x) {
  static_cast<void>(abut::rectangles(x, x, x, x));
}
#elif CASE == 5
void mixed(std::vector<float>& x, std::vector<double>& r) {
  static_cast<void>(abut::discs(x, x, r));
}
#elif CASE == 6
void mixed(std::vector<std::array<float, 3>>& points, std::vector<double>& r) {
  static_cast<void>(abut::spheres(points, r));
}
#elif CASE == 7
void mixed(std::vector<float>& x, std::vector<double>& y) {
  static_cast<void>(abut::boxes(x, x, x, x, x, y));
}
#elif CASE == 8
void mixed(std::vector<float>& x, std::span<const double> z) {
  static_cast<void>(abut::spheres(x, x, z, 0.5));
}
#endif
