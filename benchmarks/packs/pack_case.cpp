#include "benchmarks/packs/pack_case.hpp"

#include "scenes/packs.hpp"
#include "scenes/random.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace abut::benchmarks {
namespace {

constexpr std::uint64_t shuffle_seed = 1998;

scenes::Scene in_order(const PackCase& pack) {
  switch (pack.pack) {
    case 1:
      return scenes::pack_1(pack.rows, pack.columns);
    case 2:
      return scenes::pack_2(pack.rows, pack.columns, pack.spacing);
    case 3:
      return scenes::pack_3(pack.rows, pack.columns, pack.spacing);
    default:
      return scenes::pack_4(pack.rows, pack.columns, pack.spacing);
  }
}

/// Fisher and Yates.
scenes::Scene shuffled(scenes::Scene scene) {
  scenes::Random random(shuffle_seed);
  for (std::size_t k = scene.size(); k > 1; --k) {
    const std::size_t other = random.below(k);
    std::swap(scene.x[k - 1], scene.x[other]);
    std::swap(scene.y[k - 1], scene.y[other]);
    std::swap(scene.radius[k - 1], scene.radius[other]);
  }
  return scene;
}

/// Packs II to IV at each spacing.
void add_loose_cases(std::vector<PackCase>& cases, std::size_t side,
                     std::initializer_list<double> spacings) {
  for (const int pack : {2, 3, 4}) {
    for (const double spacing : spacings) cases.push_back({pack, side, side, spacing});
  }
}

}  // namespace

std::string name_of(const PackCase& pack) {
  static constexpr std::array roman{"I", "II", "III", "IV"};
  std::string name = "pack " + std::string(roman[static_cast<std::size_t>(pack.pack - 1)]) + ", " +
                     std::to_string(pack.rows) + " x " + std::to_string(pack.columns);
  if (pack.pack != 1) name += ", S/D = " + std::to_string(static_cast<int>(pack.spacing));
  if (pack.numbering == Numbering::shuffled) name += ", shuffled";
  return name;
}

scenes::Scene make_scene(const PackCase& pack) {
  return pack.numbering == Numbering::shuffled ? shuffled(in_order(pack)) : in_order(pack);
}

PairCount expected_contact_pairs(const PackCase& pack) {
  const bool touching = pack.spacing <= 1.0;
  const PairCount along_rows = PairCount{pack.rows} * (pack.columns - 1);
  const PairCount along_columns = PairCount{pack.columns} * (pack.rows - 1);
  switch (pack.pack) {
    case 1:
      return along_rows;
    case 2:
      return touching ? along_rows : 0;
    case 3:
      return touching ? along_rows + along_columns : 0;
    default:
      return touching ? along_rows : PairCount{pack.rows} * (pack.columns / 2);
  }
}

BookCells book_cells(const PackCase& pack) {
  const auto steps_x = static_cast<double>(pack.columns - 1);
  const auto steps_y = static_cast<double>(pack.rows - 1);
  const auto odd_steps = static_cast<double>(pack.columns / 2);
  const double width =
      pack.pack == 4 ? odd_steps + (steps_x - odd_steps) * pack.spacing : steps_x * pack.spacing;
  const double height = steps_y * (pack.pack == 3 ? pack.spacing : 2.0);
  return {1.0 + width, 1.0 + height};
}

std::vector<PackCase> full_cases() {
  std::vector<PackCase> cases{{1, 10, 10},     {1, 31, 32},
                              {1, 100, 100},   {1, 300, 300},
                              {1, 1000, 1000}, {1, 1000, 1000, 1.0, Numbering::shuffled}};
  add_loose_cases(cases, 100, {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0});
  return cases;
}

std::vector<PackCase> quick_cases() {
  std::vector<PackCase> cases{{1, 5, 7}, {1, 9, 8}, {1, 9, 8, 1.0, Numbering::shuffled}};
  add_loose_cases(cases, 7, {1.0, 2.0, 200.0});
  return cases;
}

}  // namespace abut::benchmarks
