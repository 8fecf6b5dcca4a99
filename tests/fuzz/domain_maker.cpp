#include "fuzz/domain_maker.hpp"

#include <abut/error.hpp>

#include <cmath>

namespace abut::fuzz {

DomainMaker::DomainMaker(ByteReader& reader, NumberMaker& numbers, int dimensions, double expanse)
    : reader_(reader), numbers_(numbers), dimensions_(static_cast<std::size_t>(dimensions)) {
  constexpr std::array<Kind, 8> kinds{Kind::open,         Kind::open,    Kind::block,
                                      Kind::block,        Kind::sheared, Kind::lattice,
                                      Kind::lees_edwards, Kind::block};
  kind_ = kinds[reader.below(kinds.size())];
  if (kind_ == Kind::open) return;
  const unsigned all = (1U << dimensions_) - 1;
  const unsigned mask = reader.byte();
  axes_ = (mask & 0x40U) != 0 ? all : mask & all;
  if (kind_ == Kind::lees_edwards) axes_ |= 2U;
  for (std::size_t k = 0; k < dimensions_; ++k) {
    vectors_[k][k] = expanse * numbers.size();
    if (kind_ == Kind::block || kind_ == Kind::lees_edwards) continue;
    for (std::size_t axis = 0; axis < dimensions_; ++axis) {
      if (axis == k) continue;
      if (kind_ == Kind::lattice) vectors_[k][axis] = expanse * numbers.number();
      // Many times the length, so that a reduced cell is quite another one.
      if (kind_ == Kind::sheared && axis < k) {
        vectors_[k][axis] = vectors_[axis][axis] * std::ldexp(reader.signed_byte(), -5) *
                            std::ldexp(1.0, reader.byte() % 24);
      }
    }
  }
  shift_ = kind_ == Kind::lees_edwards ? expanse * numbers.number() : 0.0;
}

Domain DomainMaker::made() const {
  if (kind_ == Kind::open) return Domain::open();
  const auto length = [&](std::size_t k) { return is_periodic(k) ? vectors_[k][k] : unbounded; };
  const auto axes = static_cast<Axes>(axes_);
  if (dimensions_ == 2) {
    if (kind_ == Kind::block) return Domain::periodic({length(0), length(1)});
    if (kind_ == Kind::lees_edwards) return Domain::lees_edwards({length(0), length(1)}, shift_);
    return Domain::lattice({vectors_[0][0], vectors_[0][1]}, {vectors_[1][0], vectors_[1][1]},
                           axes);
  }
  if (kind_ == Kind::block) return Domain::periodic({length(0), length(1), length(2)});
  if (kind_ == Kind::lees_edwards) {
    return Domain::lees_edwards({length(0), length(1), length(2)}, shift_);
  }
  return Domain::lattice(vectors_[0], vectors_[1], vectors_[2], axes);
}

std::optional<Domain> DomainMaker::domain() const {
  try {
    return made();
  } catch (const Error&) {
    return std::nullopt;
  }
}

void DomainMaker::move() {
  const std::size_t k = reader_.below(dimensions_);
  const double part = reader_.signed_byte() / 1024.0;
  shift_ += part * numbers_.unit();
  if (kind_ != Kind::lees_edwards) {
    for (std::size_t axis = 0; axis <= k; ++axis) vectors_[k][axis] *= 1.0 + part;
  }
}

}  // namespace abut::fuzz
