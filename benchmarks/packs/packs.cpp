// Times every algorithm of the registry on the test problems of 1998 and writes a table in CSV.
// benchmarks/packs/run runs it; docs/benchmarks.md shows what comes out.

#include "benchmarks/common/program.hpp"
#include "benchmarks/packs/measure.hpp"
#include "benchmarks/packs/pack_case.hpp"
#include "benchmarks/packs/verify.hpp"

#include <abut/error.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace abut::benchmarks {
namespace {

constexpr Effort full_effort{6.0, 3, 41, 0.002};
constexpr Effort quick_effort{0.1, 2, 2, 0.0002};

ElementView view(const scenes::Scene& scene) {
  return discs(scene.x, scene.y, scene.radius);
}

void write_header() {
  std::puts(
      "pack,rows,columns,elements,spacing,numbering,algorithm,cells_x,cells_y,form,repetitions,"
      "ns_median,ns_minimum,gather_ns,search_ns,order_ns,contact_pairs,candidate_tests,"
      "exact_decisions,list_insertions,peak_bytes,refusal");
}

/// The columns that name a case in a table.
std::string columns_of(const PackCase& pack) {
  std::ostringstream text;
  text << pack.pack << ',' << pack.rows << ',' << pack.columns << ',' << pack.elements() << ','
       << pack.spacing << ',' << (pack.numbering == Numbering::shuffled ? "shuffled" : "along");
  return text.str();
}

/// Times in nanoseconds for one element and one detection.
void write_row(const PackCase& pack, const Measurement& m) {
  const double ns = 1e9 / static_cast<double>(pack.elements());
  const BookCells cells = book_cells(pack);
  const Statistics& s = m.statistics;
  std::printf("%s,%s,%.0f,%.0f,%s,%zu,", columns_of(pack).c_str(),
              std::string(m.contestant->name).c_str(), cells.x, cells.y,
              std::string(name_of(m.form)).c_str(), m.repetitions);
  if (m.refusal.empty()) {
    std::printf("%.2f,%.2f,%.2f,%.2f,%.2f,%llu,%llu,%llu,%llu,%llu,\n", m.cpu.median * ns,
                m.cpu.minimum * ns, m.gather * ns, m.search * ns, m.order * ns,
                static_cast<unsigned long long>(s.contact_pairs),
                static_cast<unsigned long long>(s.candidate_tests),
                static_cast<unsigned long long>(s.exact_decisions),
                static_cast<unsigned long long>(s.list_insertions),
                static_cast<unsigned long long>(s.peak_bytes));
  } else {
    std::printf(",,,,,,,,,,\"%s\"\n", m.refusal.c_str());
  }
  std::fflush(stdout);
}

void run(const std::vector<PackCase>& cases, const Effort& effort) {
  write_header();
  for (const PackCase& pack : cases) {
    std::fprintf(stderr, "%s\n", name_of(pack).c_str());
    const scenes::Scene scene = make_scene(pack);
    verify(pack, view(scene));
    for (const Measurement& m : measure(view(scene), effort)) write_row(pack, m);
  }
}

/// The cases themselves, for a tool that runs them one by one.
void list(const std::vector<PackCase>& cases) {
  std::puts("pack,rows,columns,elements,spacing,numbering,algorithm");
  for (const PackCase& pack : cases) {
    for (const AlgorithmInfo& contestant : algorithms()) {
      if (!takes_part(contestant, pack.elements())) continue;
      std::printf("%s,%s\n", columns_of(pack).c_str(), std::string(contestant.name).c_str());
    }
  }
}

/// One detection, for a tool that counts its instructions.
void run_once(const PackCase& pack, const std::string& algorithm) {
  const scenes::Scene scene = make_scene(pack);
  Options options;
  options.algorithm = algorithm_named(algorithm);
  const Statistics found = count_contact_pairs(view(scene), Domain::open(), options);
  if (found.contact_pairs != expected_contact_pairs(pack)) {
    throw Error(ErrorCode::check_failed, name_of(pack) + ": " + algorithm + " counts other pairs");
  }
}

int main_of(int argc, char** argv) {
  CLI::App app(
      "Times every algorithm on packs I to IV of Munjiza and Andrews, 1998; CSV on stdout.");
  app.require_subcommand(0, 1);
  bool quick = false;
  app.add_flag("--quick", quick, "small packs, two repetitions: whether it works at all");
  const CLI::App* list_cases = app.add_subcommand("list", "the cases and who takes part");
  CLI::App* once = app.add_subcommand("once", "one detection, for counting instructions");
  PackCase pack;
  std::string algorithm;
  once->add_option("pack", pack.pack, "1 to 4")->required()->check(CLI::Range(1, 4));
  once->add_option("rows", pack.rows)->required()->check(CLI::Range(1, 10'000));
  once->add_option("columns", pack.columns)->required()->check(CLI::Range(1, 10'000));
  once->add_option("spacing", pack.spacing, "S / D")->required()->check(CLI::Range(1.0, 1e6));
  once->add_option("algorithm", algorithm)->required();
  CLI11_PARSE(app, argc, argv);
  const std::vector<PackCase> cases = quick ? quick_cases() : full_cases();
  if (once->parsed()) {
    run_once(pack, algorithm);
  } else if (list_cases->parsed()) {
    list(cases);
  } else {
    run(cases, quick ? quick_effort : full_effort);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace abut::benchmarks

int main(int argc, char** argv) {
  return abut::benchmarks::run_program("packs", abut::benchmarks::main_of, argc, argv);
}
