#pragma once

#include "base/elements.hpp"
#include "base/periodic_predicate.hpp"
#include "base/sphere_predicate.hpp"
#include "engine/images.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace abut::engine {

/// Decides pairs on the caller's numbers.
class Arbiter {
 public:
  /// Asks for what a decision will need, ahead of it.
  virtual void fetch(std::uint32_t element) const noexcept = 0;

  /// Adds one to `exact_decisions` when doubles cannot decide.
  [[nodiscard]] virtual bool within_reach(std::uint32_t first, std::uint32_t second,
                                          std::uint64_t& exact_decisions) const = 0;

 protected:
  Arbiter() = default;
  ~Arbiter() = default;
  Arbiter(const Arbiter&) = default;
  Arbiter& operator=(const Arbiter&) = default;
};

template <int Dim>
class OpenArbiter final : public Arbiter {
 public:
  OpenArbiter(const base::Elements<Dim>& originals, double margin)
      : originals_(originals), margin_(margin) {}

  void fetch(std::uint32_t element) const noexcept override {
    if (originals_.are_boxes()) {
      __builtin_prefetch(&originals_.boxes[element]);
    } else {
      __builtin_prefetch(&originals_.spheres[element]);
    }
  }

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    return originals_.within_reach(first, second, margin_, exact_decisions);
  }

 private:
  base::Elements<Dim> originals_;
  double margin_;
};

/// Numbers from the count of natives on are those of ghosts. Two ghosts are no pair.
template <int Dim>
class PeriodicArbiter final : public Arbiter {
 public:
  PeriodicArbiter(std::span<const base::Sphere<Dim>> originals, const base::Lattice& lattice,
                  const Images<Dim>& images, double margin)
      : originals_(originals), lattice_(lattice), images_(images), margin_(margin) {}

  void fetch(std::uint32_t element) const noexcept override {
    if (element < originals_.size()) __builtin_prefetch(&originals_[element]);
  }

  [[nodiscard]] bool within_reach(std::uint32_t first, std::uint32_t second,
                                  std::uint64_t& exact_decisions) const override {
    const std::size_t natives = originals_.size();
    if (second < first) std::swap(first, second);
    if (first >= natives) return false;
    if (second < natives) {
      return decide(first, second, images_.shift_between(first, second), exact_decisions);
    }
    const Ghost& ghost = images_.ghosts()[second - natives];
    return decide(first, ghost.element, images_.shift_between(first, ghost), exact_decisions);
  }

 private:
  [[nodiscard]] bool decide(std::uint32_t i, std::uint32_t j, const base::ImageShift& shift,
                            std::uint64_t& exact_decisions) const {
    return base::within_reach(originals_[i], originals_[j], shift, lattice_, margin_,
                              exact_decisions);
  }

  std::span<const base::Sphere<Dim>> originals_;
  const base::Lattice& lattice_;
  const Images<Dim>& images_;
  double margin_;
};

}  // namespace abut::engine
