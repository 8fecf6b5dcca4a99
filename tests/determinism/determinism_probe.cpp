// Prints what every algorithm finds in the stored scenes as digests, and on stderr which SIMD
// levels it tried. The same lines must come from every compiler, optimisation level and processor
// (scripts/compare-digests), and from every level and number of threads.
//   determinism_probe SCENES [GOLDEN]    with GOLDEN: every line of that file must be among them
// Exit codes: 0 as it must be, 1 a difference or a scene that tests nothing, 3 unreadable files.

#include "fnv_digest.hpp"
#include "stored_scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace abut::determinism {
namespace {

std::string digest_of(const PairList& pairs) {
  FnvDigest digest;
  for (const ContactPair& pair : pairs) {
    digest.add(pair.first);
    digest.add(pair.second);
  }
  return digest.text();
}

std::string digest_of_gaps(const ElementView& elements, const PairList& pairs) {
  FnvDigest digest;
  for (const ContactPair& pair : pairs) digest.add(gap(elements, pair));
  return digest.text();
}

/// What must be equal for all algorithms.
std::string result_line(const StoredScene& scene, const ElementView& elements,
                        const PairList& pairs) {
  return scene.name + " pairs " + std::to_string(pairs.size()) + " canonical " + digest_of(pairs) +
         " gaps " + digest_of_gaps(elements, pairs);
}

/// What is an algorithm's own.
std::string algorithm_line(const StoredScene& scene, std::string_view name, const PairList& pairs) {
  const Statistics& statistics = pairs.statistics();
  return scene.name + " " + std::string(name) + " as_found " + digest_of(pairs) + " tests " +
         std::to_string(statistics.candidate_tests) + " exact " +
         std::to_string(statistics.exact_decisions);
}

/// The ways to run an algorithm that must not show in its result: of `rows` every SIMD level that
/// this processor has, with 1, 2, 3, 7 and 16 threads.
std::vector<Options> variants_of(Algorithm algorithm, double margin) {
  const Options plain{.algorithm = algorithm, .margin = margin};
  if (algorithm != Algorithm::rows) return {plain};
  std::vector<Options> result;
  for (const Simd level : simd_levels()) {
    if (!available(level)) continue;
    for (const int threads : {1, 2, 3, 7, 16}) {
      result.push_back(plain);
      result.back().simd = level;
      result.back().threads = threads;
    }
  }
  return result;
}

/// Throws if `line` is another than the one at `place`; where there is none yet, it is the one.
void insist(std::vector<std::string>& lines, std::size_t place, const std::string& line,
            const Options& options) {
  if (lines.size() == place) lines.push_back(line);
  if (line == lines[place]) return;
  throw std::logic_error(std::string(name_of(options.algorithm)) + ", SIMD level " +
                         std::string(name_of(options.simd)) + ", " +
                         std::to_string(options.threads) + " threads, gives '" + line +
                         "' instead of '" + lines[place] + "'");
}

void probe(const StoredScene& scene, const ElementView& elements, std::vector<std::string>& lines) {
  const std::size_t result_at = lines.size();
  for (const AlgorithmInfo& info : algorithms()) {
    const std::size_t algorithm_at = std::max(lines.size(), result_at + 1);
    for (Options options : variants_of(info.algorithm, scene.margin)) {
      const PairList canonical = find_contact_pairs(elements, Domain::open(), options);
      insist(lines, result_at, result_line(scene, elements, canonical), options);
      options.order = Order::as_found;
      const PairList as_found = find_contact_pairs(elements, Domain::open(), options);
      insist(lines, algorithm_at, algorithm_line(scene, info.name, as_found), options);
      if (as_found.empty() || as_found.statistics().exact_decisions == 0) {
        throw std::logic_error(lines.back() + ": a scene without exact decisions tests nothing");
      }
      if (info.algorithm == Algorithm::rows && as_found.statistics().simd != options.simd) {
        throw std::logic_error("the SIMD level asked for did not run");
      }
    }
  }
}

std::vector<std::string> probe_all(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry);
  std::sort(files.begin(), files.end());
  std::vector<std::string> lines;
  for (const auto& file : files) {
    const StoredScene scene = read_stored_scene(file);
    if (scene.precision == Precision::float32) {
      probe(scene, SceneNumbers<float>(scene).view(), lines);
    } else {
      probe(scene, SceneNumbers<double>(scene).view(), lines);
    }
  }
  if (lines.empty()) throw std::runtime_error(folder.string() + ": no scenes");
  return lines;
}

bool has_all_lines_of(const std::filesystem::path& golden, const std::vector<std::string>& lines) {
  std::ifstream stream(golden);
  std::size_t expected = 0;
  bool equal = true;
  for (std::string line; std::getline(stream, line); ++expected) {
    if (std::find(lines.begin(), lines.end(), line) != lines.end()) continue;
    std::cerr << "not found any more: " << line << '\n';
    equal = false;
  }
  if (expected == 0) throw std::runtime_error(golden.string() + ": no lines");
  return equal;
}

int run(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: determinism_probe SCENES [GOLDEN]\n";
    return 2;
  }
  const std::vector<std::string> lines = probe_all(argv[1]);
  std::cerr << "SIMD levels:";
  for (const Simd level : simd_levels()) {
    std::cerr << ' ' << (available(level) ? "" : "no ") << name_of(level);
  }
  std::cerr << '\n';
  for (const std::string& line : lines) std::cout << line << '\n';
  return argc == 2 || has_all_lines_of(argv[2], lines) ? 0 : 1;
}

}  // namespace
}  // namespace abut::determinism

int main(int argc, char** argv) {
  try {
    return abut::determinism::run(argc, argv);
  } catch (const std::logic_error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}
