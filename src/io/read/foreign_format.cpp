#include "io/read/foreign_format.hpp"

#include "io/quoted_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::io {
namespace {

using namespace std::string_view_literals;

/// A format, its first bytes and the command that makes it readable; "@" in the command stands for
/// the file.
struct ForeignFormat {
  std::size_t offset;      ///< of the bytes in the file
  std::string_view bytes;  ///< that it has there
  std::string_view also;   ///< what else the head of a text must hold; empty: nothing
  std::string_view what;
  std::string_view command;
};

constexpr std::string_view savetxt_of_array =
    "python3 -c 'import numpy as n, sys; n.savetxt(sys.stdout, n.load(sys.argv[1]))' @ | "
    "abut contacts - --columns x,y,z,radius";
constexpr std::string_view savetxt_of_gsd =
    "python3 -c 'import gsd.hoomd as g, numpy as n, sys; p = g.open(sys.argv[1])[-1].particles; "
    "n.savetxt(sys.stdout, n.c_[p.position, p.diameter / 2])' @ | "
    "abut contacts - --columns x,y,z,radius";
constexpr std::string_view savetxt_of_hdf5 =
    "python3 -c 'import h5py as h, numpy as n, sys; n.savetxt(sys.stdout, "
    "h.File(sys.argv[1])[sys.argv[2]])' @ DATASET | abut contacts - --columns x,y,z,radius";
constexpr std::string_view savetxt_of_points =
    "python3 -c 'import pyvista as v, numpy as n, sys; d = v.read(sys.argv[1]); "
    "n.savetxt(sys.stdout, n.c_[d.points, d[sys.argv[2]]])' @ radius | "
    "abut contacts - --columns x,y,z,radius";
constexpr std::string_view first_atoms =
    "python3 -c 'import MDAnalysis as m, sys; m.Universe(sys.argv[1]).atoms.write(sys.argv[2])' @ "
    "frame.xyz";

/// Sources: the format's own description, or file(1).
constexpr ForeignFormat formats[] = {
    {0, "\x1F\x8B"sv, "", "is compressed with gzip", "gzip -dc @ | abut contacts -"},
    {0, "\x28\xB5\x2F\xFD"sv, "", "is compressed with zstd", "zstd -dc @ | abut contacts -"},
    {0, "BZh"sv, "", "is compressed with bzip2", "bzip2 -dc @ | abut contacts -"},
    {0,
     "\xFD"
     "7zXZ"sv,
     "", "is compressed with xz", "xz -dc @ | abut contacts -"},
    {0, "\x04\x22\x4D\x18"sv, "", "is compressed with lz4", "lz4 -dc @ | abut contacts -"},
    {0, "7z\xBC\xAF\x27\x1C"sv, "", "is an archive of 7-Zip", "7z x @"},
    {0, "PK\x03\x04"sv, "", "is a zip archive, as .npz and .xlsx are", "unzip @"},
    {257, "ustar"sv, "\0"sv, "is a tar archive", "tar -xf @"},
    {0, "\x93NUMPY"sv, "", "is an array of NumPy (.npy)", savetxt_of_array},
    {0, "\xDF\x65\xDF\x65\xDF\x65\xDF\x65"sv, "", "is a GSD file of HOOMD-blue", savetxt_of_gsd},
    {0, "\x89HDF\r\n\x1A\n"sv, "", "is an HDF5 file, whose datasets 'h5ls -r' lists",
     savetxt_of_hdf5},
    {0, "CDF\x01"sv, "", "is a NetCDF file", first_atoms},
    {0, "CDF\x02"sv, "", "is a NetCDF file", first_atoms},
    {0, "CDF\x05"sv, "", "is a NetCDF file", first_atoms},
    {0, "T\0\0\0CORD"sv, "", "is a DCD trajectory", first_atoms},
    {0, "\0\0\x07\xCB"sv, "", "is an XTC trajectory of GROMACS", first_atoms},
    {0, "\0\0\x07\xC9"sv, "", "is a TRR trajectory of GROMACS", first_atoms},
    {8, "DUMPATOM"sv, "\0"sv, "is a binary dump of LAMMPS", "binary2txt @"},
    {8, "DUMPCUSTOM"sv, "\0"sv, "is a binary dump of LAMMPS", "binary2txt @"},
    {0, "LammpS RestartT"sv, "", "is a restart file of LAMMPS",
     "lmp -restart2data @ elements.data"},
    {0, "PAR1\x15"sv, "", "is a Parquet file",
     "python3 -c 'import pandas as p, sys; p.read_parquet(sys.argv[1]).to_csv(sys.stdout)' @ | "
     "abut contacts -"},
    {0, "MATLAB 5.0 MAT-file"sv, "", "is a MAT-file of MATLAB",
     "python3 -c 'import scipy.io as s, numpy as n, sys; n.savetxt(sys.stdout, "
     "s.loadmat(sys.argv[1])[sys.argv[2]])' @ VARIABLE | abut contacts - --columns x,y,z,radius"},
    {0, "# vtk DataFile Version"sv, "", "is a VTK file", savetxt_of_points},
    {0, "<"sv, "<VTKFile", "is a VTK file", savetxt_of_points},
    {0, "ply"sv, "\nformat ", "is a PLY file", savetxt_of_points},
};

constexpr std::string_view no_elements =
    "holds triangles (STL), not elements; a program gives them to abut::find_mesh_contacts as "
    "walls: docs/walls.md";
constexpr std::string_view other_markup =
    "is XML or HTML, not a table of elements; write one with a header line such as x,y,z,radius";
constexpr std::string_view json =
    "is JSON, not a table of elements; write one with a header line such as x,y,z,radius";

bool is_of(const ForeignFormat& format, std::string_view head) {
  return head.size() > format.offset && head.substr(format.offset).starts_with(format.bytes) &&
         head.find(format.also) != std::string_view::npos;
}

/// Recognises binary STL: a title of 80 bytes, the number of triangles in 32 bits and 50 bytes for
/// each.
bool is_stl(const FileHead& file) {
  constexpr std::size_t title_bytes = 80;
  constexpr std::size_t header_bytes = 84;
  constexpr std::uint64_t triangle_bytes = 50;
  const std::string_view head = file.text;
  if (head.starts_with("solid") && head.find("facet ") != std::string_view::npos) return true;
  if (!file.bytes || head.size() < header_bytes) return false;
  std::uint64_t triangles = 0;
  for (std::size_t k = header_bytes; k-- > title_bytes;) {
    triangles = triangles << 8U | static_cast<unsigned char>(head[k]);
  }
  return *file.bytes == header_bytes + triangle_bytes * triangles;
}

std::string with_name(std::string_view command, std::string_view name) {
  const std::size_t place = command.find('@');
  const std::string file = name == "-" ? "FILE" : shell_quoted(name);
  return fmt::format("{}{}{}", command.substr(0, place), file, command.substr(place + 1));
}

}  // namespace

std::optional<std::string> foreign_format(const FileHead& file, std::string_view name) {
  const std::string_view head = file.text.substr(0, telling_bytes);
  for (const ForeignFormat& format : formats) {
    if (!is_of(format, head)) continue;
    return fmt::format("{}; run {}", format.what, with_name(format.command, name));
  }
  if (is_stl(file)) return std::string(no_elements);
  const std::size_t first = std::min(head.find_first_not_of(" \t\r\n"), head.size());
  const std::string_view text = head.substr(first);
  if (text.starts_with("<?xml") || text.starts_with("<!") || text.starts_with("<html")) {
    return std::string(other_markup);
  }
  if (text.starts_with("{\"") || text.starts_with("{\n") || text.starts_with("{\r\n")) {
    return std::string(json);
  }
  return std::nullopt;
}

}  // namespace abut::io
