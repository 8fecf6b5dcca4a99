// Checks each file of a folder as the fuzzers do, but in every form, with any compiler:
//   replay_cases FOLDER|FILE...
//   replay_cases --show FILE...          prints the cases, as text
//   replay_cases --random COUNT [SEED]   checks random cases as fuzz_contacts does, but unguided
//   replay_cases --write SEED            leaves the bytes of one of these in a file
//   replay_cases --walls ...             the same of the cases of fuzz_walls

#include "fuzz/check_case.hpp"
#include "fuzz/dump_case.hpp"
#include "fuzz/number_memory.hpp"
#include "fuzz/wall_case.hpp"
#include "scenes/random.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
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

/// What is asked of bytes: cases of elements, or of walls.
struct Target {
  std::function<Outcome(std::span<const std::uint8_t>, Thoroughness)> check;
  std::function<std::string(std::span<const std::uint8_t>)> dump;  ///< empty: encloses no cell
};

Target contacts() {
  return {[](std::span<const std::uint8_t> bytes, Thoroughness thoroughness) -> Outcome {
            const std::optional<Case> given = decode_case(bytes);
            return {true, given && check_case(*given, thoroughness)};
          },
          [](std::span<const std::uint8_t> bytes) {
            const std::optional<Case> given = decode_case(bytes);
            return given ? dump_case(*given) : std::string();
          }};
}

Target walls() {
  return {[](std::span<const std::uint8_t> bytes, Thoroughness) -> Outcome {
            const std::optional<WallCase> given = decode_wall_case(bytes);
            return {true, given && check_wall_case(*given)};
          },
          [](std::span<const std::uint8_t> bytes) {
            const std::optional<WallCase> given = decode_wall_case(bytes);
            return given ? dump_wall_case(*given) : std::string();
          }};
}

Outcome check(const Target& target, const std::string& name, std::span<const std::uint8_t> bytes,
              Thoroughness thoroughness) {
  try {
    return target.check(bytes, thoroughness);
  } catch (const std::exception& failure) {
    std::printf("%s: %s\n%s", name.c_str(), failure.what(), target.dump(bytes).c_str());
    return {false, true};
  }
}

int replay(const Target& target, const std::vector<fs::path>& files) {
  const auto failures = std::ranges::count_if(files, [&](const fs::path& path) {
    return !check(target, path.string(), bytes_of(path), Thoroughness::complete).passed;
  });
  std::printf("%zu cases, %zu failures\n", files.size(), static_cast<std::size_t>(failures));
  return files.empty() || failures > 0 ? 1 : 0;
}

/// Each case follows from a seed of its own.
std::string name_of_random(std::uint64_t seed) {
  return "case_" + std::to_string(seed);
}

std::vector<std::uint8_t> random_bytes(std::uint64_t seed) {
  abut::scenes::Random random(seed);
  std::vector<std::uint8_t> bytes(24 + random.below(400));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

int write_random(std::uint64_t seed) {
  const std::vector<std::uint8_t> bytes = random_bytes(seed);
  std::ofstream file(name_of_random(seed), std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  return file.flush() ? 0 : 1;
}

/// Stops at the first failure, and leaves its bytes in a file.
int check_random(const Target& target, std::uint64_t count, std::uint64_t first_seed) {
  std::uint64_t checked = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    const std::string name = name_of_random(seed);
    const Outcome outcome = check(target, name, random_bytes(seed), Thoroughness::sampled);
    checked += outcome.checked ? 1 : 0;
    if (outcome.passed) continue;
    write_random(seed);
    std::printf("%s fails, after %llu that were checked\n", name.c_str(),
                static_cast<unsigned long long>(checked - 1));
    return 1;
  }
  std::printf("%llu random cases from seed %llu on, %llu checked, no failure\n",
              static_cast<unsigned long long>(count), static_cast<unsigned long long>(first_seed),
              static_cast<unsigned long long>(checked));
  return 0;
}

int show(const Target& target, std::span<char*> paths) {
  for (const char* path : paths) {
    const std::string text = target.dump(bytes_of(path));
    std::printf("%s: %s\n", path, text.empty() ? "encloses no cell" : text.c_str());
  }
  return 0;
}

std::vector<fs::path> files_among(std::span<char*> paths) {
  std::vector<fs::path> files;
  for (const char* path : paths) {
    if (fs::is_regular_file(path)) files.emplace_back(path);
    if (!fs::is_directory(path)) continue;
    for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory_of_numbers();
  std::span<char*> words(argv + 1, argv + argc);
  const auto next_is = [&](std::string_view word) { return !words.empty() && words[0] == word; };
  const bool of_walls = next_is("--walls");
  const Target target = of_walls ? walls() : contacts();
  if (of_walls) words = words.subspan(1);
  if (next_is("--show")) return show(target, words.subspan(1));
  if (next_is("--random") && words.size() > 1) {
    return check_random(target, std::stoull(words[1]),
                        words.size() > 2 ? std::stoull(words[2]) : 1);
  }
  if (next_is("--write") && words.size() > 1) return write_random(std::stoull(words[1]));
  return replay(target, files_among(words));
}
