// SciPy's cKDTree, in a process of its own that runs Python: scipy_ckdtree.py does the work and
// measures its time; scenes and pairs pass through files in memory.

#include "benchmarks/matrix/apart.hpp"
#include "benchmarks/matrix/contestant.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// A file without a name, which other processes open by its path.
class MemoryFile {
 public:
  MemoryFile() : file_(memfd_create("scene", 0)) {
    if (file_ < 0) fail("memfd_create");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(file_); }

  [[nodiscard]] std::string path() const {
    return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(file_);
  }

 private:
  int file_;
};

template <class T>
void write_array(std::FILE* file, const T* values, std::size_t count) {
  if (count == 0) return;
  if (std::fwrite(values, sizeof(T), count, file) != count) fail("fwrite");
}

void write_scene(const Scene& scene, const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) fail("fopen");
  const std::int64_t head[] = {static_cast<std::int64_t>(scene.size()), scene.dimensions};
  write_array(file, head, 2);
  for (const auto* column : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
    write_array(file, column->data(), column->size());
  }
  std::fclose(file);
}

/// Python with the script, line for line.
class Python {
 public:
  Python() {
    int orders[2];
    int answers[2];
    if (pipe(orders) != 0 || pipe(answers) != 0) fail("pipe");
    child_ = fork();
    if (child_ < 0) fail("fork");
    if (child_ == 0) become_python(orders, answers);
    close(orders[0]);
    close(answers[1]);
    orders_ = fdopen(orders[1], "w");
    answers_ = fdopen(answers[0], "r");
  }
  Python(const Python&) = delete;
  Python& operator=(const Python&) = delete;
  ~Python() {
    std::fclose(orders_);
    std::fclose(answers_);
    waitpid(child_, nullptr, 0);
  }

  std::string ask(const std::string& order) {
    std::fprintf(orders_, "%s\n", order.c_str());
    std::fflush(orders_);
    std::string line;
    for (int c = std::fgetc(answers_); c != '\n'; c = std::fgetc(answers_)) {
      if (c == EOF) throw std::runtime_error("Python ended without an answer");
      line.push_back(static_cast<char>(c));
    }
    return line;
  }

 private:
  [[noreturn]] static void become_python(const int (&orders)[2], const int (&answers)[2]) {
    end_with_parent();
    dup2(orders[0], STDIN_FILENO);
    dup2(answers[1], STDOUT_FILENO);
    close(orders[1]);
    close(answers[0]);
    setenv("OPENBLAS_NUM_THREADS", "1", 1);
    execl(ABUT_PYTHON, ABUT_PYTHON, ABUT_SCIPY_SCRIPT, nullptr);
    _exit(127);
  }

  pid_t child_ = -1;
  std::FILE* orders_ = nullptr;
  std::FILE* answers_ = nullptr;
};

class ScipyCkdtree final : public Contestant {
 public:
  void prepare(const Scene& scene) override {
    write_scene(scene, scene_.path());
    static_cast<void>(python_.ask(scene_.path()));
  }

  Answer run(const Scene&) override {
    std::istringstream answer(python_.ask("run"));
    std::string word;
    std::size_t count = 0;
    answer >> word;
    if (word != "found") throw std::bad_alloc();
    answer >> seconds_.wall >> seconds_.cpu >> count >> candidates_;
    read_pairs(count);
    return {pairs_, count};
  }

  [[nodiscard]] Counters counters() const override { return {candidates_, 0, {}}; }
  [[nodiscard]] std::optional<Seconds> own_clock() const override { return seconds_; }

 private:
  void read_pairs(std::size_t count) {
    pairs_.resize(count);
    static_cast<void>(python_.ask("pairs " + found_.path()));
    std::FILE* const file = std::fopen(found_.path().c_str(), "rb");
    if (file == nullptr) fail("fopen");
    const std::size_t read =
        count == 0 ? 0 : std::fread(pairs_.data(), sizeof(ContactPair), count, file);
    std::fclose(file);
    if (read != count) throw std::runtime_error("Python wrote too few pairs");
  }

  MemoryFile scene_;
  MemoryFile found_;
  Python python_;
  Seconds seconds_;
  std::uint64_t candidates_ = 0;
  std::vector<ContactPair> pairs_;
};

}  // namespace

std::vector<Entry> enter_scipy_ckdtree() {
  Entry entry = package_entry("scipy_ckdtree", "SciPy " ABUT_SCIPY_VERSION " cKDTree.query_pairs");
  entry.make = [] { return std::make_unique<ScipyCkdtree>(); };
  return {entry};
}

}  // namespace abut::benchmarks
