#include "detect/public_calls.hpp"

#include "detect/given.hpp"

#include <abut/abut.hpp>
#include <abut/trace.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace abut::testing {
namespace {

/// Looks at what an algorithm shows, and keeps nothing.
class Onlooker final : public trace::Sink {
 public:
  void stage(std::string_view, std::array<std::int32_t, 3>) override {}
  void array(const trace::Array&) override {}
  void search_step(const trace::SearchStep&) override {}
  void candidate_pair(ElementIndex, ElementIndex) override {}
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Calls = std::vector<PublicCall>;

void add_free_functions(Calls& calls) {
  const Given& g = given();
  for (const Domain* domain : {&g.open, &g.block}) {
    const std::string where = domain->is_periodic() ? "in a cell" : "in open space";
    for (const Options* options : {&g.shifted, &g.ruled}) {
      calls.push_back({"abut::find_contact_pairs", where, [&g, domain, options] {
                         (void)find_contact_pairs(g.elements, *domain, *options);
                       }});
    }
    calls.push_back({"abut::find_contact_pairs", "two sets, " + where, [&g, domain] {
                       (void)find_contact_pairs(g.elements, g.others, *domain, g.shifted);
                     }});
    calls.push_back({"abut::find_contact_pairs", "boxes, " + where,
                     [&g, domain] { (void)find_contact_pairs(g.boxes, *domain, g.shifted); }});
    calls.push_back({"abut::count_contact_pairs", where,
                     [&g, domain] { (void)count_contact_pairs(g.elements, *domain); }});
    calls.push_back({"abut::count_contact_pairs", "two sets, " + where,
                     [&g, domain] { (void)count_contact_pairs(g.elements, g.others, *domain); }});
    calls.push_back({"abut::for_each_batch", where,
                     [&g, domain] { for_each_batch(g.elements, *domain, {}, g.visit); }});
    calls.push_back({"abut::for_each_batch", "two sets, " + where,
                     [&g, domain] { for_each_batch(g.elements, g.others, *domain, {}, g.visit); }});
    calls.push_back({"abut::for_each_shifted_batch", where, [&g, domain] {
                       for_each_shifted_batch(g.elements, *domain, {}, g.visit_shifted);
                     }});
    calls.push_back({"abut::for_each_shifted_batch", "two sets, " + where, [&g, domain] {
                       for_each_shifted_batch(g.elements, g.others, *domain, {}, g.visit_shifted);
                     }});
    for (const NeighborListKind kind : {NeighborListKind::half, NeighborListKind::full}) {
      calls.push_back({"abut::build_neighbor_list", where, [&g, domain, kind] {
                         (void)build_neighbor_list(g.elements, *domain, kind, g.measured);
                       }});
    }
    calls.push_back({"abut::build_neighbor_list", "two sets, " + where, [&g, domain] {
                       (void)build_neighbor_list(g.elements, g.others, *domain, g.measured);
                     }});
    calls.push_back(
        {"abut::neighbors", where, [&g, domain] { (void)neighbors(g.points, 0.7, *domain); }});
  }
}

void add_measures_and_orders(Calls& calls) {
  const Given& g = given();
  const auto measured = Quantity::gap | Quantity::point;
  calls.push_back({"abut::measure", "", [&g, measured] {
                     (void)measure(g.elements, g.shifted_pairs, measured, g.block);
                   }});
  calls.push_back({"abut::measure", "two sets",
                   [&g, measured] { (void)measure(g.elements, g.elements, g.pairs, measured); }});
  calls.push_back(
      {"abut::PairMeasurer::PairMeasurer", "", [&g] { (void)PairMeasurer(g.elements, g.block); }});
  calls.push_back({"abut::PairMeasurer::PairMeasurer", "two sets",
                   [&g] { (void)PairMeasurer(g.elements, g.others, g.open); }});
  static std::vector<double> gaps(g.pairs.size());
  calls.push_back(
      {"abut::measure", "into an array", [&g] { measure(g.elements, g.pairs, {.gaps = gaps}); }});
  calls.push_back({"abut::measure", "of two sets, into an array",
                   [&g] { measure(g.elements, g.elements, g.pairs, {.gaps = gaps}); }});
  calls.push_back({"abut::spatial_order", "", [&g] { (void)spatial_order(g.elements); }});
  calls.push_back({"abut::PairMeasurer::measure", "",
                   [&g] { PairMeasurer(g.elements).measure(g.pairs, {.gaps = gaps}); }});
}

void add_wall_measures(Calls& calls) {
  const Given& g = given();
  static const ContactList<MeshContact> touching = find_mesh_contacts(g.elements, g.mesh);
  static const ContactList<BoxContact> near = find_box_contacts(g.elements, g.boxes);
  static std::vector<double> mesh_gaps(touching.size());
  static std::vector<double> box_gaps(near.size());
  calls.push_back({"abut::measure", "a mesh",
                   [&g] { (void)measure(g.elements, g.mesh, touching, Quantity::point); }});
  calls.push_back({"abut::measure", "boxes as walls",
                   [&g] { (void)measure(g.elements, g.boxes, near, Quantity::point); }});
  calls.push_back({"abut::measure", "a mesh, into an array",
                   [&g] { measure(g.elements, g.mesh, touching, {.gaps = mesh_gaps}); }});
  calls.push_back({"abut::measure", "boxes as walls, into an array",
                   [&g] { measure(g.elements, g.boxes, near, {.gaps = box_gaps}); }});
}

void add_candidates(Calls& calls) {
  const Given& g = given();
  const auto add = [&](const char* name, const std::function<void(CandidateList&)>& use) {
    calls.push_back({name, "", [use] {
                       CandidateList candidates(0.1);
                       use(candidates);
                     }});
  };
  add("abut::CandidateList::CandidateList", [](CandidateList&) {});
  add("abut::CandidateList::rebuild", [&g](CandidateList& c) { c.rebuild(g.elements, g.block); });
  add("abut::CandidateList::needs_rebuild", [&g](CandidateList& c) {
    c.rebuild(g.elements);
    (void)c.needs_rebuild(g.elements);
  });
  add("abut::CandidateList::rows", [](CandidateList& c) { (void)c.rows(); });
  add("abut::CandidateList::skin", [](CandidateList& c) { (void)c.skin(); });
  add("abut::CandidateList::rebuilds", [](CandidateList& c) { (void)c.rebuilds(); });
}

void add_refusals(Calls& calls) {
  const Given& g = given();
  const auto add = [&](const char* name, ErrorCode code, std::function<void()> call) {
    calls.push_back({name, "refused", std::move(call), code});
  };
  using enum ErrorCode;
  add("abut::find_contact_pairs", invalid_input,
      [&g] { (void)find_contact_pairs(g.elements, g.open, g.bad_margin); });
  add("abut::find_contact_pairs", invalid_input,
      [&g] { (void)find_contact_pairs(g.elements, g.open, g.bad_rule); });
  add("abut::find_contact_pairs", limit_exceeded,
      [&g] { (void)find_contact_pairs(g.elements, g.open, g.few); });
  add("abut::find_contact_pairs", wrong_usage,
      [&g] { (void)find_contact_pairs(g.elements, g.flat); });
  add("abut::build_neighbor_list", wrong_usage,
      [&g] { (void)build_neighbor_list(g.elements, g.flat, g.open, g.measured); });
  add("abut::measure", wrong_usage,
      [&g] { (void)measure(g.elements, g.pairs, Quantity::gap, g.block); });
  add("abut::neighbors", invalid_input, [&g] { (void)neighbors(g.points, -1.0); });
  add("abut::gap", wrong_usage, [&g] { (void)gap(g.elements, {0, 1000}); });
  add("abut::gap", wrong_usage, [&g] { (void)gap(g.elements, g.open, {0, 1}, {1, 0, 0}); });
  add("abut::gap", wrong_usage, [&g] { (void)gap(g.elements, g.flat, {0, 1}); });
  add("abut::gap", wrong_usage, [&g] { (void)gap(g.elements, g.flat, g.open, {0, 1}, {}); });
  add("abut::Domain::Domain", wrong_usage, [] {
    (void)Domain::lattice({1.0, 0.0}, {0.0, 1.0}, Axes::z);
  });
  add("abut::Domain::lattice", invalid_input, [] {
    (void)Domain::lattice({1.0, 0.0}, {2.0, 0.0});
  });
  add("abut::Domain::lattice", invalid_input, [] {
    (void)Domain::lattice({1, 0, 0}, {0, nan, 0}, {0, 0, 1});
  });
  add("abut::Domain::sheared", invalid_input, [] { (void)Domain::periodic({1.0, -1.0}); });
  add("abut::ElementView::require_size", invalid_input,
      [&g] { (void)discs(g.scene.x, g.others_scene.y, 1.0); });
  add("abut::Skin::fixed", invalid_input, [] { (void)Skin::fixed(-1.0); });
  add("abut::algorithm_named", wrong_usage, [] { (void)algorithm_named("no such algorithm"); });
  add("abut::simd_named", wrong_usage, [] { (void)simd_named("no such instruction set"); });
  add("abut::info", wrong_usage, [] { (void)info(Algorithm::automatic); });
}

void add_lists_and_tables(Calls& calls) {
  const Given& g = given();
  calls.push_back(
      {"abut::ExclusionList::ExclusionList", "one set", [&g] { ExclusionList(g.excluded, 200); }});
  calls.push_back({"abut::ExclusionList::ExclusionList", "two sets",
                   [&g] { ExclusionList(g.excluded, 200, 100); }});
  calls.push_back({"abut::ExclusionList::ExclusionList", "refused",
                   [&g] { ExclusionList(g.bad_excluded, 200); }, ErrorCode::invalid_input});
  calls.push_back({"abut::GroupTable::GroupTable", "", [] { GroupTable(100); }});
  calls.push_back({"abut::GroupTable::GroupTable", "refused", [] { GroupTable(1U << 30); },
                   ErrorCode::limit_exceeded});
  calls.push_back({"abut::GroupTable::allow", "refused", [] { GroupTable(3).allow(1, 3); },
                   ErrorCode::wrong_usage});
  calls.push_back({"abut::GroupTable::deny", "refused", [] { GroupTable(3).deny(3, 1); },
                   ErrorCode::wrong_usage});
  calls.push_back({"abut::build_description", "", [] { (void)build_description(); }});
  calls.push_back(
      {"abut::trace::integerise", "", [&g] { (void)trace::integerise(g.elements, {}); }});
  calls.push_back({"abut::trace::integerise", "refused",
                   [&g] { (void)trace::integerise(g.elements, g.bad_margin); },
                   ErrorCode::invalid_input});
  calls.push_back(
      {"abut::trace::first_partition", "", [&g] { (void)trace::first_partition(g.numbers); }});
  for (const AlgorithmInfo& row : algorithms()) {
    calls.push_back({"abut::trace::run", std::string(row.name),
                     [&g, &row] {
                       Onlooker onlooker;
                       trace::run(row.algorithm, g.cells, onlooker);
                     },
                     row.traceable ? std::optional<ErrorCode>() : ErrorCode::wrong_usage});
  }
}

void add_walls(Calls& calls) {
  const Given& g = given();
  calls.push_back(
      {"abut::TriangleMesh::TriangleMesh", "", [&g] { TriangleMesh(g.corners, g.faces); }});
  calls.push_back({"abut::TriangleMesh::TriangleMesh", "refused",
                   [&g] { TriangleMesh(g.corners, g.bad_faces); }, ErrorCode::invalid_input});
  calls.push_back({"abut::TriangleMesh::TriangleMesh", "in two dimensions",
                   [&g] { TriangleMesh(g.flat, g.faces); }, ErrorCode::wrong_usage});
  for (const Domain* domain : {&g.open, &g.block}) {
    const std::string where = domain->is_periodic() ? "in a cell" : "in open space";
    calls.push_back({"abut::TriangleMesh::joined", where,
                     [&g, domain] { (void)TriangleMesh::joined(g.corners, g.faces, *domain); }});
    calls.push_back({"abut::find_box_contacts", where, [&g, domain] {
                       (void)find_box_contacts(g.elements, g.boxes, *domain, g.shifted);
                     }});
    calls.push_back({"abut::find_mesh_contacts", where, [&g, domain] {
                       (void)find_mesh_contacts(g.elements, g.mesh, *domain, g.shifted);
                     }});
  }
  calls.push_back({"abut::find_box_contacts", "refused",
                   [&g] { (void)find_box_contacts(g.flat, g.boxes); }, ErrorCode::wrong_usage});
  calls.push_back({"abut::find_box_contacts", "margin refused",
                   [&g] { (void)find_box_contacts(g.elements, g.boxes, g.bad_margin); },
                   ErrorCode::invalid_input});
  calls.push_back({"abut::find_mesh_contacts", "of another domain",
                   [&g] { (void)find_mesh_contacts(g.elements, g.joined, g.other_block); },
                   ErrorCode::wrong_usage});
}

/// Adds one use of a Detector twice, without a skin and with one.
class DetectorCalls {
 public:
  explicit DetectorCalls(Calls& calls) : calls_(calls) {}

  void operator()(const char* name, const std::string& what,
                  const std::function<void(Detector&)>& use) const {
    for (const Skin skin : {Skin::none(), Skin::fixed(0.1)}) {
      calls_.push_back(
          {name, what + (skin.kind() == Skin::Kind::none ? "" : ", skin"), [use, skin] {
             Detector detector;
             detector.set_skin(skin);
             use(detector);
           }});
    }
  }

 private:
  Calls& calls_;
};

void add_moving_meshes(Calls& calls) {
  const Given& g = given();
  const DetectorCalls add(calls);
  for (const Domain* domain : {&g.open, &g.block}) {
    const std::string where = domain->is_periodic() ? "in a cell" : "in open space";
    add("abut::Detector::find_mesh_contacts", where,
        [&g, domain](Detector& d) { d.find_mesh_contacts(g.elements, g.mesh, *domain); });
    add("abut::Detector::find_box_contacts", where,
        [&g, domain](Detector& d) { d.find_box_contacts(g.elements, g.boxes, *domain); });
  }
  add("abut::TriangleMesh::move", "between two calls", [&g](Detector& d) {
    TriangleMesh mesh(g.corners, g.faces);
    d.find_mesh_contacts(g.elements, mesh);
    mesh.move({.translation = {0.5, 0.0, 0.0}});
    d.find_mesh_contacts(g.elements, mesh);
  });
  add("abut::TriangleMesh::deform", "between two calls", [&g](Detector& d) {
    TriangleMesh mesh(g.corners, g.faces);
    d.find_mesh_contacts(g.elements, mesh);
    mesh.deform(g.corners);
    d.find_mesh_contacts(g.elements, mesh);
  });
}

void add_views_of_boxes(Calls& calls) {
  static const FittedBoxes uneven = [] {
    FittedBoxes boxes = given().mesh.boxes();
    boxes.upper[1].pop_back();
    return boxes;
  }();
  calls.push_back({"abut::FittedBoxes::view", "refused", [] { (void)uneven.view(); },
                   ErrorCode::invalid_input});
}

void add_detector_settings(Calls& calls) {
  const Given& g = given();
  const DetectorCalls add(calls);
  add("abut::Detector::Detector", "", [](Detector&) {});
  add("abut::Detector::set_skin", "", [](Detector& d) { d.set_skin(Skin::automatic()); });
  add("abut::Detector::set_ids", "small", [&g](Detector& d) { d.set_ids(g.ids); });
  add("abut::Detector::set_ids", "large", [&g](Detector& d) { d.set_ids(g.large_ids); });
  calls.push_back({"abut::Detector::set_ids", "refused", [&g] { Detector().set_ids(g.ids_twice); },
                   ErrorCode::invalid_input});
}

void add_detector(Calls& calls) {
  const Given& g = given();
  const DetectorCalls add(calls);
  for (const Domain* domain : {&g.open, &g.block}) {
    const std::string where = domain->is_periodic() ? "in a cell" : "in open space";
    add("abut::Detector::find_contact_pairs", where,
        [&g, domain](Detector& d) { d.find_contact_pairs(g.elements, *domain); });
    add("abut::Detector::find_contact_pairs", "two sets, " + where,
        [&g, domain](Detector& d) { d.find_contact_pairs(g.elements, g.others, *domain); });
    add("abut::Detector::count_contact_pairs", where,
        [&g, domain](Detector& d) { d.count_contact_pairs(g.elements, *domain); });
    add("abut::Detector::count_contact_pairs", "two sets, " + where,
        [&g, domain](Detector& d) { d.count_contact_pairs(g.elements, g.others, *domain); });
    add("abut::Detector::for_each_batch", where,
        [&g, domain](Detector& d) { d.for_each_batch(g.elements, *domain, g.visit); });
    add("abut::Detector::for_each_batch", "two sets, " + where,
        [&g, domain](Detector& d) { d.for_each_batch(g.elements, g.others, *domain, g.visit); });
    add("abut::Detector::for_each_shifted_batch", where, [&g, domain](Detector& d) {
      d.for_each_shifted_batch(g.elements, *domain, g.visit_shifted);
    });
    add("abut::Detector::for_each_shifted_batch", "two sets, " + where, [&g, domain](Detector& d) {
      d.for_each_shifted_batch(g.elements, g.others, *domain, g.visit_shifted);
    });
    add("abut::Detector::build_neighbor_list", where, [&g, domain](Detector& d) {
      d.build_neighbor_list(g.elements, *domain, NeighborListKind::full);
    });
    add("abut::Detector::build_neighbor_list", "two sets, " + where,
        [&g, domain](Detector& d) { d.build_neighbor_list(g.elements, g.others, *domain); });
  }
}

}  // namespace

std::vector<PublicCall> public_calls() {
  Calls calls;
  add_free_functions(calls);
  add_measures_and_orders(calls);
  add_wall_measures(calls);
  add_candidates(calls);
  add_refusals(calls);
  add_lists_and_tables(calls);
  add_walls(calls);
  add_moving_meshes(calls);
  add_views_of_boxes(calls);
  add_detector_settings(calls);
  add_detector(calls);
  add_history_calls(calls);
  add_cell_calls(calls);
  return calls;
}

}  // namespace abut::testing
