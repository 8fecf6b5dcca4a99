#pragma once

#include "command_contacts.hpp"
#include "phase_seconds.hpp"

#include <abut/pair_list.hpp>

#include <string>

namespace abut::cli {

/// Elements, where they live, and their contacts.
struct Contacts {
  const io::Snapshot& snapshot;
  const Domain& domain;
  const PairList& pairs;  ///< with their shifts where the domain is periodic

  [[nodiscard]] ImageShift shift(std::size_t k) const {
    return pairs.shifts().empty() ? ImageShift{} : pairs.shifts()[k];
  }
};

/// What people want to know about a packing at first sight.
[[nodiscard]] std::string contact_summary(const ContactsOptions& options, const Contacts& contacts,
                                          const PhaseSeconds& seconds);

}  // namespace abut::cli
