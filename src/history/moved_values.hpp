#pragma once

#include <abut/contact_history.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace abut::history {

/// Brings the values of contacts to the places that their contacts have now, with all workers. A
/// value is some bytes that the caller gives a meaning.
///
/// Each worker writes a part of the array, and reads what was in it before. Values that come from
/// elsewhere are saved aside before anyone writes: contacts move by little from step to step, so
/// that these are few.
class MovedValues {
 public:
  using Run = detail::ContactMatcher::Run;
  using Values = detail::ContactMatcher::Values;

  /// Moves values within one array. Runs keep their order; `values` has room for the contacts of
  /// both steps. Takes all memory before a value moves.
  void shift(std::span<const Run> runs, const Values& values, std::size_t workers);

  /// Copies values to another array; runs come in any order.
  static void copy(std::span<const Run> runs, const std::byte* from, const Values& to,
                   std::size_t workers);

 private:
  void save(std::span<const Run> runs, const Values& values, std::size_t worker,
            std::size_t workers);

  std::vector<std::vector<std::byte>> saved_;  ///< of each worker
};

}  // namespace abut::history
