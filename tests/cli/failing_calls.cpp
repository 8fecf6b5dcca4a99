// Stands before system calls of the tool and lets one of them fail: that of the name and number in
// ABUT_FAULT, "write 3 ENOSPC", in one of these ways:
//   an error       the call does nothing and reports it
//   SHORT          write takes one byte
//   SIGTERM, ...   the signal comes before the call, which is then made
//   TWICE          SIGTERM comes two times
// Where ABUT_LEAKS names a file, the descriptors that are open at the end are written to it, one a
// line. Files of the system (below /proc, /sys, /etc, /usr) are let alone, and so is each
// descriptor that was not opened by `open`: a runtime of threads keeps memory shared, under a name
// with the number of the process, and closes it more often where a killed process left that name
// behind.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#define EXPORTED extern "C" __attribute__((visibility("default")))

namespace {

struct Name {
  const char* name;
  int number;
};
constexpr Name errors[] = {{"ENOSPC", ENOSPC}, {"EIO", EIO},       {"EINTR", EINTR},
                           {"EDQUOT", EDQUOT}, {"EACCES", EACCES}, {"EROFS", EROFS},
                           {"EMFILE", EMFILE}, {"EFBIG", EFBIG},   {"EPIPE", EPIPE}};
constexpr Name signals[] = {{"SIGTERM", SIGTERM}, {"SIGINT", SIGINT},   {"SIGHUP", SIGHUP},
                            {"SIGXFSZ", SIGXFSZ}, {"SIGPIPE", SIGPIPE}, {"TWICE", 0}};

struct Fault {
  std::string call;
  long number = 0;
  std::string way;

  Fault() {
    char name[20] = "";
    char how[20] = "";
    const char* const text = std::getenv("ABUT_FAULT");
    if (text == nullptr || std::sscanf(text, "%19s %ld %19s", name, &number, how) != 3) return;
    call = name;
    way = how;
  }
};

/// Whether this call fails, with errno set; raises the signals that are wanted.
bool fails(const char* call) {
  static const Fault fault;
  static long made = 0;
  if (fault.call != call || ++made != fault.number) return false;
  for (const Name& error : errors) {
    if (fault.way != error.name) continue;
    errno = error.number;
    return true;
  }
  for (const Name& signal : signals) {
    if (fault.way != signal.name) continue;
    std::raise(signal.number == 0 ? SIGTERM : signal.number);
    if (signal.number == 0) std::raise(SIGTERM);
  }
  return false;
}

bool is_short() {
  static const Fault fault;
  static long made = 0;
  return fault.call == "write" && fault.way == "SHORT" && ++made == fault.number;
}

template <class Function>
Function* genuine(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool is_of_the_system(const char* path) {
  for (const char* folder : {"/proc/", "/sys/", "/etc/", "/usr/", "/lib"}) {
    if (std::strncmp(path, folder, std::strlen(folder)) == 0) return true;
  }
  return false;
}

constexpr int descriptors = 256;
bool is_of_the_tool[descriptors];

/// Whether `open` gave this descriptor and it is closed now for the first time since.
bool leaves_the_tool(int descriptor) {
  if (descriptor < 0 || descriptor >= descriptors) return false;
  return std::exchange(is_of_the_tool[descriptor], false);
}

struct AtTheEnd {
  ~AtTheEnd() {
    const char* const path = std::getenv("ABUT_LEAKS");
    if (path == nullptr) return;
    std::FILE* const file = std::fopen(path, "w");
    for (int descriptor = 3; descriptor < descriptors; ++descriptor) {
      if (descriptor == fileno(file)) continue;
      if (::fcntl(descriptor, F_GETFD) != -1) std::fprintf(file, "%d\n", descriptor);
    }
    std::fclose(file);
  }
} at_the_end;

}  // namespace

EXPORTED int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  const bool is_ours = !is_of_the_system(path);
  if (is_ours && fails("open")) return -1;
  static auto* const call = genuine<int(const char*, int, ...)>("open");
  const int descriptor = call(path, flags, mode);
  if (descriptor >= 0 && descriptor < descriptors) is_of_the_tool[descriptor] = is_ours;
  return descriptor;
}

EXPORTED ssize_t read(int descriptor, void* bytes, size_t size) {
  if (fails("read")) return -1;
  static auto* const call = genuine<ssize_t(int, void*, size_t)>("read");
  return call(descriptor, bytes, size);
}

EXPORTED ssize_t write(int descriptor, const void* bytes, size_t size) {
  if (fails("write")) return -1;
  static auto* const call = genuine<ssize_t(int, const void*, size_t)>("write");
  return call(descriptor, bytes, is_short() && size > 0 ? 1 : size);
}

EXPORTED int fsync(int descriptor) {
  if (fails("fsync")) return -1;
  static auto* const call = genuine<int(int)>("fsync");
  return call(descriptor);
}

/// As Linux does it: the descriptor is closed whatever is reported.
EXPORTED int close(int descriptor) {
  const bool failed = leaves_the_tool(descriptor) && fails("close");
  const int error = errno;
  static auto* const call = genuine<int(int)>("close");
  const int result = call(descriptor);
  if (!failed) return result;
  errno = error;
  return -1;
}

EXPORTED int rename(const char* from, const char* to) noexcept {
  if (fails("rename")) return -1;
  static auto* const call = genuine<int(const char*, const char*)>("rename");
  return call(from, to);
}

EXPORTED int fchmod(int descriptor, mode_t mode) noexcept {
  if (fails("fchmod")) return -1;
  static auto* const call = genuine<int(int, mode_t)>("fchmod");
  return call(descriptor, mode);
}
