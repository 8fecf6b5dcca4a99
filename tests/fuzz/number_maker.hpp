#pragma once

#include "fuzz/byte_reader.hpp"

#include <abut/element_view.hpp>

namespace abut::fuzz {

/// Numbers of few bits over a common unit, of which many sums and squares tie; and, where the bytes
/// ask for them, those that lie beside them or far away.
class NumberMaker {
 public:
  NumberMaker(ByteReader& reader, Precision precision);

  /// Rounded to float where numbers are of single precision; finite.
  [[nodiscard]] double number();
  [[nodiscard]] double size();  ///< not negative

  /// A number moved by one last place or none.
  [[nodiscard]] double nudged(double value);

  /// The finite number of the precision nearest to `value`.
  [[nodiscard]] double fitted(double value) const;

  [[nodiscard]] double unit() const noexcept { return unit_; }

 private:
  [[nodiscard]] double exotic(double plain);

  ByteReader& reader_;
  Precision precision_;
  double unit_ = 1.0;
  unsigned spice_ = 0;  ///< which kinds of exotic numbers there are, one bit each
};

}  // namespace abut::fuzz
