// Prints what every algorithm finds in the stored scenes as digests. The same lines must come from
// every compiler, optimisation level and processor (scripts/compare-digests).
//   determinism_probe SCENES [GOLDEN]    with GOLDEN: every line of that file must be among them
// Exit codes: 0 as it must be, 1 a difference or a scene that tests nothing, 3 unreadable files.

#include "fnv_digest.hpp"
#include "stored_scene.hpp"

#include <abut/abut.hpp>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

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

void probe(const StoredScene& scene, const ElementView& elements, std::vector<std::string>& lines) {
  const std::size_t result_at = lines.size();
  for (const AlgorithmInfo& info : algorithms()) {
    Options options{.algorithm = info.algorithm, .margin = scene.margin};
    const PairList canonical = find_contact_pairs(elements, Domain::open(), options);
    const std::string result = result_line(scene, elements, canonical);
    if (lines.size() == result_at) lines.push_back(result);
    if (result != lines[result_at]) {
      throw std::logic_error("algorithms disagree: " + std::string(info.name) + " gives " + result +
                             ", the first one " + lines[result_at]);
    }
    options.order = Order::as_found;
    const PairList as_found = find_contact_pairs(elements, Domain::open(), options);
    lines.push_back(algorithm_line(scene, info.name, as_found));
    if (as_found.empty() || as_found.statistics().exact_decisions == 0) {
      throw std::logic_error(lines.back() + ": a scene without exact decisions tests nothing");
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
