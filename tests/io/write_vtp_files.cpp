// Writes the files that check_vtp.py reads: write_vtp_files FOLDER

#include "io/read/read_snapshot.hpp"
#include "io/write/write_contacts.hpp"

#include <abut/detect.hpp>
#include <abut/two_sets.hpp>

#include <exception>
#include <iostream>
#include <string>

namespace {

using abut::io::Snapshot;

void write(const std::string& path, const Snapshot& snapshot,
           const abut::Domain& domain = abut::Domain::open()) {
  abut::Options options;
  options.shifts = abut::Shifts::stored;
  if (domain.is_periodic()) {
    using abut::Quantity;
    options.quantities =
        Quantity::gap | Quantity::normal | Quantity::point | Quantity::distance | Quantity::vector;
  }
  const abut::PairList pairs = abut::find_contact_pairs(snapshot.elements(), domain, options);
  abut::io::write_contacts(
      {path, abut::io::ContactFormat::vtp, abut::io::IdColumns::without, {}}, snapshot,
      pairs.pairs(), {pairs.shifts(), domain},
      {pairs.gaps(), pairs.normals(), pairs.points(), pairs.distances(), pairs.vectors()});
}

/// Two discs with ids against those of another file, in the cell (3, 0), (0, 9).
void write_two_sets(const std::string& folder, const Snapshot& second) {
  Snapshot first;
  first.dimensions = 2;
  first.x = {0.25, 1};
  first.y = {8.5, 1};
  first.radius = {0.5, 0.125};
  first.ids = {7, 8};
  abut::Options options;
  options.shifts = abut::Shifts::stored;
  const abut::Domain domain = abut::Domain::periodic({3.0, 9.0});
  const abut::PairList pairs =
      abut::find_contact_pairs(first.elements(), second.elements(), domain, options);
  abut::io::write_contacts(
      {folder + "/two_sets.vtp", abut::io::ContactFormat::vtp, abut::io::IdColumns::without, {}},
      {first, second}, pairs.pairs(), {pairs.shifts(), domain});
}

void write_all(const std::string& folder) {
  write(folder + "/spheres.vtp", abut::io::read_snapshot(ABUT_EXAMPLE_DATA "/lammps_pour.dump"));

  Snapshot discs;
  discs.dimensions = 2;
  discs.x = {0, 1, 2.5, 9};
  discs.y = {0, 0, 0, 9};
  discs.radius = {0.5, 0.75, 0.75, 0.25};
  write(folder + "/discs.vtp", discs);
  write(folder + "/periodic.vtp", discs, abut::Domain::lattice({3, 0}, {1, 9}));

  discs.ids = {1, 2, 3, 4};
  write_two_sets(folder, discs);

  Snapshot alone;
  alone.x = alone.y = alone.z = alone.radius = {1};
  write(folder + "/alone.vtp", alone);
  write(folder + "/nothing.vtp", Snapshot{});
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  try {
    write_all(words[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
