#include "detect/given.hpp"
#include "detect/public_calls.hpp"

#include <abut/abut.hpp>

#include <array>
#include <vector>

namespace abut::testing {
namespace {

void add_history(std::vector<PublicCall>& calls) {
  const Given& g = given();
  calls.push_back(
      {"abut::detail::ContactMatcher::ContactMatcher", "", [] { ContactHistory<double>(); }});
  calls.push_back({"abut::detail::ContactMatcher::match", "", [&g] {
                     ContactHistory<double> history;
                     history.update(g.pairs_before, g.elements);
                     history.update(g.pairs, g.elements);
                   }});
  calls.push_back(
      {"abut::detail::ContactMatcher::lack_memory", "in the history's own arrays", [&g] {
         ContactHistory<std::array<double, 9>> history;
         history.update(g.pairs, g.elements, g.open, g.ids);
         history.update(g.pairs_before, g.elements, g.open, g.large_ids);
         history.clear();
       }});
  calls.push_back({"abut::detail::ContactMatcher::move_values", "by several workers", [&g] {
                     ContactHistory<double> history(g.several);
                     history.update(g.pairs_before, g.elements);
                     history.update(g.pairs, g.elements);
                   }});
  calls.push_back({"abut::detail::ContactMatcher::copy_values", "by several workers", [&g] {
                     ContactHistory<double> history(g.several);
                     history.update(g.pairs, g.elements, g.open, g.ids);
                     history.update(g.pairs_before, g.elements, g.open, g.large_ids);
                   }});
  calls.push_back({"abut::detail::ContactMatcher::match", "in a cell", [&g] {
                     ContactHistory<double> history;
                     history.update(g.shifted_pairs, g.elements, g.block, g.ids);
                     history.update(g.shifted_pairs, g.elements, g.block, g.large_ids);
                   }});
  calls.push_back({"abut::detail::ContactMatcher::match", "refused",
                   [&g] { ContactHistory<double>().update(g.pairs, g.elements, g.block); },
                   ErrorCode::wrong_usage});
}

void add_wall_history(std::vector<PublicCall>& calls) {
  const Given& g = given();
  static const MeshContactList near = find_mesh_contacts(g.elements, g.mesh, {.margin = 0.1});
  static const MeshContactList touching = find_mesh_contacts(g.elements, g.mesh);
  static const BoxContactList boxed =
      find_box_contacts(g.elements, g.boxes, g.block, {.shifts = Shifts::stored});
  calls.push_back(
      {"abut::detail::WallMatcher::WallMatcher", "", [] { MeshContactHistory<double>(); }});
  calls.push_back({"abut::detail::WallMatcher::match", "a mesh", [&g] {
                     MeshContactHistory<std::array<double, 9>> history;
                     history.update(near, g.elements, g.mesh, g.open, g.ids);
                     history.update(touching, g.elements, g.mesh, g.open, g.large_ids);
                   }});
  calls.push_back({"abut::detail::WallMatcher::match", "boxes in a cell", [&g] {
                     BoxContactHistory<double> history;
                     history.update(boxed, g.elements, g.block, g.ids);
                     history.update(boxed, g.elements, g.block, g.large_ids);
                   }});
}

}  // namespace

void add_history_calls(std::vector<PublicCall>& calls) {
  add_history(calls);
  add_wall_history(calls);
}

}  // namespace abut::testing
