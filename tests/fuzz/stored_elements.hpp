#pragma once

#include "fuzz/fuzz_case.hpp"

#include <abut/element_view.hpp>

#include <vector>

namespace abut::fuzz {

/// Elements in memory as a caller may have them, and the view of them.
class StoredElements {
 public:
  StoredElements(const ElementArrays& elements, const Storage& storage);

  [[nodiscard]] ElementView view() const;

 private:
  template <class T>
  void store(std::vector<T>& memory);
  template <class T>
  [[nodiscard]] ElementView view_of(const std::vector<T>& memory) const;
  template <class T, std::size_t Dim>
  [[nodiscard]] ElementView view_of(const std::vector<T>& memory) const;

  const ElementArrays& elements_;
  Storage storage_;
  std::vector<const std::vector<double>*> columns_;
  std::vector<double> doubles_;
  std::vector<float> floats_;
};

}  // namespace abut::fuzz
