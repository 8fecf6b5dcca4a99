// Checks each file of a folder as the fuzzers do, but in every form, with any compiler:
//   replay_cases FOLDER|FILE...
//   replay_cases --show FILE...          prints the cases, as text
//   replay_cases --random COUNT [SEED]   checks random cases as fuzz_contacts does, but unguided

#include "fuzz/check_case.hpp"
#include "fuzz/dump_case.hpp"
#include "fuzz/number_memory.hpp"
#include "scenes/random.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace abut::fuzz;
namespace fs = std::filesystem;

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Outcome {
  bool passed = true;
  bool checked = false;  ///< neither without a cell nor with too many images
};

Outcome check(const std::string& name, std::span<const std::uint8_t> bytes,
              Thoroughness thoroughness) {
  const std::optional<Case> given = decode_case(bytes);
  if (!given) return {};
  try {
    return {true, check_case(*given, thoroughness)};
  } catch (const std::exception& failure) {
    std::printf("%s: %s\n%s", name.c_str(), failure.what(), dump_case(*given).c_str());
    return {false, true};
  }
}

int replay(const std::vector<fs::path>& files) {
  const auto failures = std::ranges::count_if(files, [](const fs::path& path) {
    return !check(path.string(), bytes_of(path), Thoroughness::complete).passed;
  });
  std::printf("%zu cases, %zu failures\n", files.size(), static_cast<std::size_t>(failures));
  return files.empty() || failures > 0 ? 1 : 0;
}

/// Each case follows from a seed of its own. Stops at the first failure, and leaves its bytes in a
/// file.
int check_random(std::uint64_t count, std::uint64_t first_seed) {
  std::uint64_t checked = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    abut::scenes::Random random(seed);
    std::vector<std::uint8_t> bytes(24 + random.below(400));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
    const std::string name = "case_" + std::to_string(seed);
    const Outcome outcome = check(name, bytes, Thoroughness::sampled);
    checked += outcome.checked ? 1 : 0;
    if (outcome.passed) continue;
    std::ofstream(name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    std::printf("%s fails, after %llu that were checked\n", name.c_str(),
                static_cast<unsigned long long>(checked - 1));
    return 1;
  }
  std::printf("%llu random cases from seed %llu on, %llu checked, no failure\n",
              static_cast<unsigned long long>(count), static_cast<unsigned long long>(first_seed),
              static_cast<unsigned long long>(checked));
  return 0;
}

int show(std::span<char*> paths) {
  for (const char* path : paths) {
    const std::optional<Case> given = decode_case(bytes_of(path));
    std::printf("%s: %s\n", path, given ? dump_case(*given).c_str() : "encloses no cell");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory_of_numbers();
  if (argc > 1 && std::string_view(argv[1]) == "--show") {
    return show(std::span(argv + 2, argv + argc));
  }
  if (argc > 2 && std::string_view(argv[1]) == "--random") {
    return check_random(std::stoull(argv[2]), argc > 3 ? std::stoull(argv[3]) : 1);
  }
  std::vector<fs::path> files;
  for (int k = 1; k < argc; ++k) {
    if (fs::is_regular_file(argv[k])) files.emplace_back(argv[k]);
    if (!fs::is_directory(argv[k])) continue;
    for (const auto& entry : fs::directory_iterator(argv[k])) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return replay(files);
}
