#include "fuzz/question.hpp"

#include <array>

namespace abut::fuzz {

Question::Question(const System& system, const Expected& expected)
    : system_(system), expected_(expected), first_(system.first, system.storage[0]) {
  if (system.second) second_.emplace(*system.second, system.storage[1]);
  if (!system.rule.excluded) return;
  if (system.second) {
    exclusions_.emplace(*system.rule.excluded, system.first.size(), system.second->size());
  } else {
    exclusions_.emplace(*system.rule.excluded, system.first.size());
  }
}

std::size_t Question::element_count() const {
  return system_.first.size() + (system_.second ? system_.second->size() : 0);
}

testing::ExactOracle Question::oracle() const {
  return {system_.second ? testing::joined(system_.first, *system_.second) : system_.first,
          system_.domain, system_.margin};
}

ImagePair Question::in_oracle(ImagePair image) const {
  if (has_two_sets()) image.pair.second += static_cast<ElementIndex>(system_.first.size());
  return image;
}

Options Question::options() const {
  Options options;
  options.margin = system_.margin;
  options.rule.elements = system_.rule.traits[0].view();
  if (system_.second) options.rule.others = system_.rule.traits[1].view();
  if (system_.rule.table) options.rule.table = &*system_.rule.table;
  if (exclusions_) options.rule.exclusions = &*exclusions_;
  return options;
}

PairList FreeFunctions::list() const {
  const Question& q = question;
  return q.has_two_sets() ? find_contact_pairs(q.first(), q.second(), q.domain(), options)
                          : find_contact_pairs(q.first(), q.domain(), options);
}

Statistics FreeFunctions::count() const {
  const Question& q = question;
  return q.has_two_sets() ? count_contact_pairs(q.first(), q.second(), q.domain(), options)
                          : count_contact_pairs(q.first(), q.domain(), options);
}

Statistics FreeFunctions::visit(const PairBatchVisitor& visitor) const {
  const Question& q = question;
  return q.has_two_sets() ? for_each_batch(q.first(), q.second(), q.domain(), options, visitor)
                          : for_each_batch(q.first(), q.domain(), options, visitor);
}

Statistics FreeFunctions::visit(const ShiftedBatchVisitor& visitor) const {
  const Question& q = question;
  return q.has_two_sets()
             ? for_each_shifted_batch(q.first(), q.second(), q.domain(), options, visitor)
             : for_each_shifted_batch(q.first(), q.domain(), options, visitor);
}

NeighborList FreeFunctions::neighbors(NeighborListKind kind) const {
  const Question& q = question;
  return q.has_two_sets() ? build_neighbor_list(q.first(), q.second(), q.domain(), options)
                          : build_neighbor_list(q.first(), q.domain(), kind, options);
}

const PairList& AskedDetector::list() const {
  const Question& q = question;
  detector.set_options(options);
  return q.has_two_sets() ? detector.find_contact_pairs(q.first(), q.second(), q.domain())
                          : detector.find_contact_pairs(q.first(), q.domain());
}

Statistics AskedDetector::count() const {
  const Question& q = question;
  detector.set_options(options);
  return q.has_two_sets() ? detector.count_contact_pairs(q.first(), q.second(), q.domain())
                          : detector.count_contact_pairs(q.first(), q.domain());
}

Statistics AskedDetector::visit(const PairBatchVisitor& visitor) const {
  const Question& q = question;
  detector.set_options(options);
  return q.has_two_sets() ? detector.for_each_batch(q.first(), q.second(), q.domain(), visitor)
                          : detector.for_each_batch(q.first(), q.domain(), visitor);
}

Statistics AskedDetector::visit(const ShiftedBatchVisitor& visitor) const {
  const Question& q = question;
  detector.set_options(options);
  return q.has_two_sets()
             ? detector.for_each_shifted_batch(q.first(), q.second(), q.domain(), visitor)
             : detector.for_each_shifted_batch(q.first(), q.domain(), visitor);
}

const NeighborList& AskedDetector::neighbors(NeighborListKind kind) const {
  const Question& q = question;
  detector.set_options(options);
  return q.has_two_sets() ? detector.build_neighbor_list(q.first(), q.second(), q.domain())
                          : detector.build_neighbor_list(q.first(), q.domain(), kind);
}

}  // namespace abut::fuzz
