#include "detect/given.hpp"
#include "detect/public_calls.hpp"

#include <abut/abut.hpp>

#include <vector>

namespace abut::testing {

void add_cell_calls(std::vector<PublicCall>& calls) {
  const Given& g = given();
  const auto view = [&g] { return simplices_3d(g.corners, g.faces); };
  const auto broken = [&g] { return simplices_3d(g.corners, g.bad_faces); };
  calls.push_back({"abut::fit_boxes", "", [&g] { (void)fit_boxes_3d(g.corners, g.faces, 0.1); }});
  calls.push_back({"abut::fit_boxes", "refused",
                   [&g] { (void)fit_boxes_3d(g.corners, g.faces, -1.0); },
                   ErrorCode::invalid_input});
  calls.push_back({"abut::fit_boxes", "vertex refused",
                   [&g] { (void)fit_boxes_3d(g.corners, g.bad_faces); }, ErrorCode::invalid_input});
  calls.push_back({"abut::SimplexView::SimplexView", "refused",
                   [&g] { (void)SimplexView(g.boxes, g.faces); }, ErrorCode::wrong_usage});
  calls.push_back(
      {"abut::find_simplex_contacts", "", [view] { (void)find_simplex_contacts(view()); }});
  calls.push_back({"abut::find_simplex_contacts", "vertex refused",
                   [broken] { (void)find_simplex_contacts(broken()); }, ErrorCode::invalid_input});
  calls.push_back({"abut::find_simplex_contacts", "in open space",
                   [&g, view] { (void)find_simplex_contacts(view(), g.open); }});
  calls.push_back({"abut::find_simplex_contacts", "in a cell",
                   [&g, view] { (void)find_simplex_contacts(view(), g.block, g.shifted); }});
  calls.push_back({"abut::find_simplex_contacts", "two sets",
                   [view] { (void)find_simplex_contacts(view(), view()); }});
  calls.push_back({"abut::find_simplex_contacts", "two sets, in open space",
                   [&g, view] { (void)find_simplex_contacts(view(), view(), g.open); }});
  calls.push_back({"abut::touching", "refused",
                   [view] {
                     (void)touching(view(), view(), {0, 77});
                   },
                   ErrorCode::wrong_usage});
  calls.push_back({"abut::touching", "image refused",
                   [&g, view] {
                     (void)touching(view(), view(), g.open, {0, 0}, {1, 0, 0});
                   },
                   ErrorCode::wrong_usage});
}

}  // namespace abut::testing
