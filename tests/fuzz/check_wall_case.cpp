#include "exact/features/geometry_oracle.hpp"
#include "fuzz/expected_walls.hpp"
#include "fuzz/question.hpp"
#include "fuzz/stored_elements.hpp"
#include "fuzz/wall_case.hpp"

#include <abut/algorithm.hpp>
#include <abut/error.hpp>
#include <abut/mesh_contacts.hpp>
#include <abut/simd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace abut::fuzz {
namespace {

constexpr std::uint64_t most_images = 200;

/// Heads of cells follow the extent; more of them would only take time.
constexpr std::uint64_t most_bytes_of_grids = 1U << 18;

Options chosen_options(const WallCase& given, Algorithm algorithm, std::size_t k) {
  const unsigned choice = given.choices[k % given.choices.size()];
  std::vector<Simd> levels;
  for (const Simd level : simd_levels()) {
    if (available(level)) levels.push_back(level);
  }
  Options options{.algorithm = algorithm,
                  .shifts = Shifts::stored,
                  .quantities = testing::all_quantities,
                  .margin = given.margin};
  options.simd = levels[choice % levels.size()];
  options.threads = choice / 16 < 12 ? 1 : static_cast<int>(choice / 16) - 11;
  if (algorithm != Algorithm::rows && algorithm != Algorithm::direct_check &&
      algorithm != Algorithm::automatic) {
    options.max_bytes = most_bytes_of_grids;
  }
  return options;
}

testing::MovedContact moved(const MeshContact& contact, const ImageShift& shift) {
  return {contact, shift};
}
MovedBoxContact moved(const BoxContact& contact, const ImageShift& shift) {
  return {contact, shift};
}

/// Throws where a quantity of a contact is not the one in rational numbers.
void check_geometry(const std::string& where, const auto& list, std::size_t k,
                    const testing::WallGeometry& expected, double radius) {
  const exact::FeatureGeometry found{list.gaps()[k], list.distances()[k], list.normals()[k],
                                     list.points()[k], list.vectors()[k]};
  const std::string fault = testing::fault_of(found, expected, radius);
  if (!fault.empty()) throw Failure(where + "contact " + std::to_string(k) + ": " + fault);
}

/// Asks every algorithm; `find(options)` is the library's list, and `geometry(contact)` what the
/// contract says about one of its contacts.
template <class Contact>
void check_all(const WallCase& given, const char* what, const ExpectedContacts<Contact>& expected,
               auto&& find, auto&& geometry) {
  std::optional<bool> refused;
  const auto check = [&](Algorithm algorithm, std::size_t k) {
    const std::string where = std::string(what) + ", " + std::string(name_of(algorithm)) + ": ";
    try {
      const auto list = find(chosen_options(given, algorithm, k));
      std::vector<Contact> found;
      for (std::size_t c = 0; c < list.size(); ++c) {
        found.push_back(moved(list[c], list.shifts()[c]));
      }
      if (found != expected.contacts) {
        throw Failure(where + std::to_string(expected.contacts.size()) + " contacts expected, " +
                      std::to_string(found.size()) + " found, or others");
      }
      for (std::size_t c = 0; c < found.size(); ++c) {
        const double radius = given.balls.radius[list[c].sphere];
        check_geometry(where, list, c, geometry(found[c]), radius);
      }
      if (refused.value_or(false)) throw Failure(where + "no error, where others refuse");
      refused = false;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::limit_exceeded && k > 2) return;
      const bool may = error.code() == ErrorCode::invalid_input && expected.may_refuse;
      if (!may) throw Failure(where + error.what());
      if (!refused.value_or(true)) throw Failure(where + error.what() + ", where others do not");
      refused = true;
    }
  };
  check(Algorithm::direct_check, 0);
  check(Algorithm::rows, 1);
  check(Algorithm::automatic, 2);
  if (given.domain.is_periodic()) return;
  std::size_t k = 3;
  for (const AlgorithmInfo& row : algorithms()) check(row.algorithm, k++);
}

}  // namespace

bool check_wall_case(const WallCase& given) {
  const StoredElements balls(given.balls, given.storage[0]);
  const StoredElements solids(given.solids, given.storage[1]);
  const auto of_boxes = expected_box_contacts(given, most_images);
  if (of_boxes) {
    check_all(
        given, "boxes", *of_boxes,
        [&](const Options& options) {
          return find_box_contacts(balls.view(), solids.view(), given.domain, options);
        },
        [&](const MovedBoxContact& moved) { return expected_geometry(given, moved); });
  }
  if (given.balls.dimensions == 2 || given.mesh.triangles.empty()) return of_boxes.has_value();
  const auto of_mesh = expected_mesh_contacts(given, most_images);
  if (!of_mesh) return false;
  const TriangleMesh mesh = given.mesh.mesh();
  check_all(
      given, "mesh", *of_mesh,
      [&](const Options& options) {
        return find_mesh_contacts(balls.view(), mesh, given.domain, options);
      },
      [&](const testing::MovedContact& moved) { return expected_geometry(given, mesh, moved); });
  return true;
}

}  // namespace abut::fuzz
