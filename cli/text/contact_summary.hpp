#pragma once

#include "commands/command_contacts.hpp"
#include "contact_findings.hpp"
#include "element_sets.hpp"
#include "options/rule_options.hpp"
#include "phase_seconds.hpp"

#include <abut/pair_list.hpp>

#include <string>

namespace abut::cli {

/// Elements, who of them may pair, and their contacts.
struct Contacts {
  const ElementSets& sets;
  const LoadedRule& rule;
  const PairList& pairs;  ///< with their shifts where the domain is periodic
  const Findings& found;
};

/// The summary that people want of a packing at first sight.
[[nodiscard]] std::string contact_summary(const ContactsOptions& options, const Contacts& contacts,
                                          const PhaseSeconds& seconds);

}  // namespace abut::cli
