#include "skin/quanta.hpp"

#include <cmath>

namespace abut::skin {

template <int Dim>
Quanta<Dim>::Quanta(double largest, const std::array<double, Dim>& middle) noexcept {
  if (!(largest > 0x1p-900 && largest < 0x1p900)) return;
  scale_.per_length = most * std::ldexp(0.5, -std::ilogb(largest));
  std::copy(middle.begin(), middle.end(), scale_.middle);
}

template <int Dim>
void Quanta<Dim>::fill(const exact::Sphere<Dim>* spheres, const ElementIndex* numbers,
                       std::span<kernels::QuantumSphere> slots, Simd level) const {
  if (slots.empty()) return;
  std::size_t k = 0;
  if constexpr (Dim == 3) {
    k = kernels::candidate_kernels(level).fill(
        {spheres->center, numbers, slots.size(), slots.data(), scale_});
  }
  for (; k < slots.size(); ++k) slots[k] = of(spheres[numbers == nullptr ? k : numbers[k]]);
}

template class Quanta<2>;
template class Quanta<3>;

}  // namespace abut::skin
