#pragma once

#include "fuzz/expected.hpp"
#include "fuzz/stored_elements.hpp"
#include "support/exact_oracle.hpp"

#include <abut/detector.hpp>
#include <abut/exclusion_list.hpp>
#include <abut/options.hpp>
#include <abut/two_sets.hpp>

#include <array>
#include <optional>
#include <stdexcept>

namespace abut::fuzz {

/// A difference between the library and the contract.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A system as it is given to the library, with the answer that is expected.
class Question {
 public:
  Question(const System& system, const Expected& expected);

  [[nodiscard]] const System& system() const noexcept { return system_; }
  [[nodiscard]] const Expected& expected() const noexcept { return expected_; }
  [[nodiscard]] ElementView first() const { return first_.view(); }
  [[nodiscard]] ElementView second() const { return second_->view(); }
  [[nodiscard]] bool has_two_sets() const noexcept { return second_.has_value(); }
  [[nodiscard]] std::size_t element_count() const;
  [[nodiscard]] const Domain& domain() const noexcept { return system_.domain; }

  /// The contract about all elements; those of a second set stand behind the first.
  [[nodiscard]] testing::ExactOracle oracle() const;
  /// An image of the question as that oracle numbers its elements.
  [[nodiscard]] ImagePair in_oracle(ImagePair image) const;

  /// Margin and rule of the system.
  [[nodiscard]] Options options() const;

 private:
  const System& system_;
  const Expected& expected_;
  StoredElements first_;
  std::optional<StoredElements> second_;
  std::optional<ExclusionList> exclusions_;
};

/// Asks by the free functions.
struct FreeFunctions {
  const Question& question;
  Options options;

  [[nodiscard]] PairList list() const;
  [[nodiscard]] Statistics count() const;
  [[nodiscard]] Statistics visit(const PairBatchVisitor& visitor) const;
  [[nodiscard]] Statistics visit(const ShiftedBatchVisitor& visitor) const;
  [[nodiscard]] NeighborList neighbors(NeighborListKind kind) const;
};

/// Asks a Detector, which may have been asked before.
struct AskedDetector {
  const Question& question;
  Options options;
  Detector& detector;

  [[nodiscard]] const PairList& list() const;
  [[nodiscard]] Statistics count() const;
  [[nodiscard]] Statistics visit(const PairBatchVisitor& visitor) const;
  [[nodiscard]] Statistics visit(const ShiftedBatchVisitor& visitor) const;
  [[nodiscard]] const NeighborList& neighbors(NeighborListKind kind) const;
};

}  // namespace abut::fuzz
