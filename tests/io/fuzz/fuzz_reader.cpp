// Gives bytes to the reader of one format, as a file and as a pipe. Whatever they are, both read
// the same elements or both throw Error; elements that are read are finite and survive being
// written.

#include "io/read/read_snapshot.hpp"
#include "io/write/write_elements.hpp"

#include <abut/error.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using abut::io::Snapshot;

constexpr std::size_t pipe_bytes = 65536;  // what a pipe takes without a reader

void require(bool holds) {
  if (!holds) std::abort();
}

/// A file in memory, read again by its name.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("fuzz", 0)) { require(descriptor_ >= 0); }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  void hold(const std::uint8_t* data, std::size_t size) const {
    require(::pwrite(descriptor_, data, size, 0) == static_cast<ssize_t>(size));
  }
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

std::optional<Snapshot> read(const std::string& path, std::optional<std::int64_t> frame) {
  abut::io::ReadOptions options;
  options.format = ABUT_FUZZED_FORMAT;
  options.frame = frame;
  options.group_columns = abut::io::GroupColumns::sought;
  try {
    return abut::io::read_snapshot(path, options);
  } catch (const abut::Error& error) {
    require(error.code() == abut::ErrorCode::invalid_input);
    require(std::strlen(error.what()) < 3000);
    return std::nullopt;
  }
}

std::optional<Snapshot> read_piped(const std::uint8_t* data, std::size_t size,
                                   std::optional<std::int64_t> frame) {
  int ends[2];
  require(::pipe(ends) == 0);
  require(::write(ends[1], data, size) == static_cast<ssize_t>(size));
  ::close(ends[1]);
  auto snapshot = read("/proc/self/fd/" + std::to_string(ends[0]), frame);
  ::close(ends[0]);
  return snapshot;
}

void require_same(const std::vector<double>& a, const std::vector<double>& b) {
  require(a.size() == b.size());
  require(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

void require_same(const Snapshot& a, const Snapshot& b) {
  require(a.dimensions == b.dimensions);
  require_same(a.x, b.x);
  require_same(a.y, b.y);
  require_same(a.z, b.z);
  require_same(a.radius, b.radius);
  require(a.ids == b.ids);
}

/// LAMMPS data files are read only.
constexpr bool is_written = std::string_view(ABUT_FUZZED_FORMAT) != "lammps_data";

void require_sound(const Snapshot& snapshot) {
  require(snapshot.y.size() == snapshot.size() && snapshot.radius.size() == snapshot.size());
  require(snapshot.z.size() == (snapshot.dimensions == 3 ? snapshot.size() : 0));
  require(snapshot.ids.empty() || snapshot.ids.size() == snapshot.size());
  require(snapshot.frame >= 0 && snapshot.frame < snapshot.frame_count);
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    require(std::isfinite(snapshot.x[k]) && std::isfinite(snapshot.y[k]));
    require(snapshot.radius[k] >= 0.0 && std::isfinite(snapshot.radius[k]));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > pipe_bytes) return 0;
  const MemoryFile file;
  file.hold(data, size);
  for (const std::optional<std::int64_t> frame : {std::optional<std::int64_t>(), {0}, {-2}}) {
    const std::optional<Snapshot> snapshot = read(file.path(), frame);
    const std::optional<Snapshot> piped = read_piped(data, size, frame);
    require(snapshot.has_value() == piped.has_value());
    if (!snapshot) continue;
    require_sound(*snapshot);
    require_same(*snapshot, *piped);
    require(snapshot->group_columns == piped->group_columns);
    if (!is_written) continue;
    const MemoryFile copy;
    abut::io::write_elements(copy.path(), ABUT_FUZZED_FORMAT, *snapshot);
    if (const std::optional<Snapshot> again = read(copy.path(), {}); snapshot->size() > 0) {
      require(again.has_value());
      require_same(*again, *snapshot);
    }
  }
  return 0;
}
