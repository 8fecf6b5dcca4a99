#include "io/read/foreign_format.hpp"

#include "scratch.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

namespace abut::io::testing {
namespace {

using namespace std::string_literals;
using namespace std::string_view_literals;

struct Foreign {
  std::string name;
  std::string text;
  std::string what;     ///< what the sentence calls it
  std::string command;  ///< what it says to run
};

const std::string zeros(600, '\0');

const Foreign foreign_files[] = {
    {"a.csv.gz", "\x1F\x8B\x08\0"s, "gzip", "gzip -dc FOLDER/a.csv.gz | abut contacts -"},
    {"a.zst", "\x28\xB5\x2F\xFD"s, "zstd", "zstd -dc FOLDER/a.zst | abut contacts -"},
    {"a.bz2", "BZh91AY"s, "bzip2", "bzip2 -dc FOLDER/a.bz2"},
    {"a.xz",
     "\xFD"
     "7zXZ\0"s,
     "xz", "xz -dc FOLDER/a.xz"},
    {"a.lz4", "\x04\x22\x4D\x18"s, "lz4", "lz4 -dc FOLDER/a.lz4"},
    {"a.7z", "7z\xBC\xAF\x27\x1C"s, "7-Zip", "7z x FOLDER/a.7z"},
    {"a.npz", "PK\x03\x04\x14"s, "zip", "unzip FOLDER/a.npz"},
    {"a.tar", zeros.substr(0, 257) + "ustar  \0"s + zeros, "tar", "tar -xf FOLDER/a.tar"},
    {"a.npy", "\x93NUMPY\x01\0v\0{'descr': "s, "NumPy", "n.load(sys.argv[1]))' FOLDER/a.npy |"},
    {"a.gsd", "\xDF\x65\xDF\x65\xDF\x65\xDF\x65"s + zeros, "GSD", "gsd.hoomd"},
    {"a b.h5", "\x89HDF\r\n\x1A\n"s + zeros, "HDF5", "' 'FOLDER/a b.h5' DATASET | abut contacts"},
    {"a.nc", "CDF\x02\0\0"s, "NetCDF", "FOLDER/a.nc frame.xyz"},
    {"a.dcd", "T\0\0\0CORD"s + zeros, "DCD", "FOLDER/a.dcd frame.xyz"},
    {"a.xtc", "\0\0\x07\xCB\0\0\0\x0A"s, "XTC", "FOLDER/a.xtc frame.xyz"},
    {"a.trr", "\0\0\x07\xC9\0\0\0\x0D"s, "TRR", "FOLDER/a.trr frame.xyz"},
    {"a.bin",
     "\xF6\xFF\xFF\xFF\xFF\xFF\xFF\xFF"
     "DUMPCUSTOM\1\0\0\0"s,
     "LAMMPS", "binary2txt"},
    {"a.restart", "LammpS RestartT\0\1\0"s, "LAMMPS", "-restart2data FOLDER/a.restart"},
    {"a.parquet", "PAR1\x15\x04"s, "Parquet", "read_parquet"},
    {"a.mat", "MATLAB 5.0 MAT-file, Platform"s, "MATLAB", "loadmat"},
    {"a.vtk", "# vtk DataFile Version 3.0\nx,y\nASCII\n"s, "VTK", "pyvista"},
    {"a.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n"s, "VTK", "pyvista"},
    {"a.ply", "ply\r\nformat ascii 1.0\r\n"s, "PLY", "pyvista"},
    {"a.stl", "solid a\n facet normal 0 0 1\n"s, "triangles", "find_mesh_contacts"},
    {"b.stl", std::string(80, ' ') + "\2\0\0\0"s + zeros.substr(0, 100), "triangles", "walls"},
    {"a.xml", "<?xml version=\"1.0\"?>\n<scene/>\n"s, "XML", "x,y,z,radius"},
    {"a.csv", "<!DOCTYPE html>\n<html>"s, "HTML", "x,y,z,radius"},
    {"a.json", "{\"x\": [1, 2]}\n"s, "JSON", "x,y,z,radius"},
};

TEST(ForeignFormat, IsNamedWithTheNextCommand) {
  const Scratch scratch;
  const std::string folder = scratch.path("");
  for (const Foreign& foreign : foreign_files) {
    SCOPED_TRACE(foreign.name);
    const std::string path = scratch.file(foreign.name, foreign.text);
    std::string sentence =
        sentence_of(ErrorCode::invalid_input, [&] { static_cast<void>(read_snapshot(path)); });
    for (std::size_t at = 0; (at = sentence.find(folder, at)) != std::string::npos;) {
      sentence.replace(at, folder.size(), "FOLDER/");
    }
    EXPECT_TRUE(sentence.starts_with("FOLDER/" + foreign.name + ": ")) << sentence;
    EXPECT_NE(sentence.find(foreign.what), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(foreign.command), std::string::npos) << sentence;
  }
}

TEST(ForeignFormat, OfAPipeHasAPlaceForTheName) {
  const std::string sentence = *foreign_format({"\x93NUMPY\x01", {}}, "-");
  EXPECT_NE(sentence.find("' FILE | abut"), std::string::npos) << sentence;
}

/// Text that begins as a foreign format does, and binary of a size that is no STL's.
TEST(ForeignFormat, IsNotSeenInText) {
  std::string late(300, 'u');
  late += "ustar";
  for (const std::string_view text :
       {"PAR1,x,y,radius\n"sv, "plyer x y radius\n"sv, "solid,x,y,radius\n"sv,
        "x y CORD radius\n"sv, "[comment\n"sv, "{comment\n"sv, "x\n"sv, ""sv,
        "# vtk and more\nx,y,radius\n"sv, "<comment>\n"sv, std::string_view(late)}) {
    EXPECT_EQ(foreign_format({text, text.size()}, "a"), std::nullopt) << text;
  }
  const std::string binary = std::string(80, ' ') + "\3\0\0\0"s + std::string(100, '\0');
  EXPECT_EQ(foreign_format({binary, binary.size()}, "a"), std::nullopt);
  EXPECT_EQ(foreign_format({binary, {}}, "a"), std::nullopt);
}

}  // namespace
}  // namespace abut::io::testing
