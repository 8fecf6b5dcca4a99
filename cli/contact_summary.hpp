#pragma once

#include "command_contacts.hpp"
#include "phase_seconds.hpp"

#include <abut/pair_list.hpp>

#include <string>

namespace abut::cli {

/// What people want to know about a packing at first sight.
[[nodiscard]] std::string contact_summary(const ContactsOptions& options,
                                          const io::Snapshot& snapshot, const PairList& pairs,
                                          const PhaseSeconds& seconds);

}  // namespace abut::cli
