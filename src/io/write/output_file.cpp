#include "io/write/output_file.hpp"

#include "io/quoted_text.hpp"
#include "io/write/output_path.hpp"

#include <abut/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

namespace abut::io {
namespace {

/// The temporary that the process would leave behind if it ended here.
std::atomic<const char*> exposed_temporary{nullptr};
static_assert(std::atomic<const char*>::is_always_lock_free, "signal handlers look at it");

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

std::string random_name() {
  std::uint64_t number = 0;
  while (::getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number)) {
  }
  return fmt::format(".abut-{:016x}.tmp", number);
}

/// fsync says so where a file or folder cannot be synced at all; that is no loss.
bool cannot_sync(int error) {
  return error == EINVAL || error == EROFS || error == ENOTSUP;
}

}  // namespace

OutputFile::OutputFile(std::string path, GiveUp give_up)
    : path_(std::move(path)), give_up_(std::move(give_up)) {
  const bool has_nul = path_.find('\0') != std::string::npos;
  if (has_nul || path_.empty()) fail("name", EINVAL);
  if (const std::optional<int> descriptor = named_descriptor(path_)) {
    open_standard_output(*descriptor);
    return;
  }
  try {
    target_ = followed(path_);
  } catch (const std::system_error& error) {
    fail("follow", error.code().value());
  }
  struct stat status {};
  if (::stat(target_.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    open_straight();
  } else {
    open_temporary();
  }
}

OutputFile::~OutputFile() {
  discard();
}

/// A descriptor of our own, so that closing reports what the system could not write.
void OutputFile::open_standard_output(int descriptor) {
  standard_output_ = descriptor == STDOUT_FILENO;
  descriptor_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 3);
  if (descriptor_ < 0) fail("open", errno);
}

void OutputFile::open_straight() {
  do {
    stop_if_given_up();
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  } while (descriptor_ < 0 && errno == EINTR);
  if (descriptor_ < 0) fail("open", errno);
}

void OutputFile::open_temporary() {
  struct stat status {};
  const bool replaces = ::stat(target_.c_str(), &status) == 0;
  // Replacing a file needs no right to write to it; whoever took that right away meant it.
  if (replaces && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) {
    fail("open", errno);
  }
  const std::string folder = folder_of(target_);
  constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW;
  const mode_t mode = replaces ? 0600 : 0666;
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = folder + '/' + random_name();
    exposed_temporary = temporary_.c_str();
    descriptor_ = ::open(temporary_.c_str(), flags, mode);
    if (descriptor_ >= 0 || (errno == EEXIST && attempt < 100)) continue;
    if (errno == EINTR) {
      stop_if_given_up();
      continue;
    }
    const int error = errno;
    forget_temporary();
    fail(fmt::format("create a file in the folder {} for", visible(folder)), error);
  }
  if (!replaces) return;
  // The owner can be kept by the superuser only; the permissions always.
  static_cast<void>(::fchown(descriptor_, status.st_uid, status.st_gid) != 0);
  if (::fchmod(descriptor_, status.st_mode & 07777) != 0) {
    const int error = errno;
    discard();
    fail("set the permissions of", error);
  }
}

void OutputFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  if (buffer_.size() >= buffer_bytes) flush();
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    stop_if_given_up();
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    const int error = errno;
    if (error == EINTR) continue;
    if (error == EPIPE && standard_output_) {
      buffer_.clear();
      throw ClosedPipe{};
    }
    fail("write to", error);
  }
  buffer_.clear();
}

void OutputFile::stop_if_given_up() const {
  if (!give_up_ || !give_up_()) return;
  throw Error(ErrorCode::cancelled, fmt::format("cancelled while writing {}", name()));
}

void OutputFile::sync() const {
  while (::fsync(descriptor_) != 0) {
    if (cannot_sync(errno)) return;
    if (errno != EINTR) fail("write to", errno);
    stop_if_given_up();
  }
}

void OutputFile::close() {
  const int descriptor = std::exchange(descriptor_, -1);
  // After EINTR the descriptor is closed on Linux; closing again could hit another file.
  if (::close(descriptor) != 0 && errno != EINTR) fail("close", errno);
}

Durability OutputFile::commit() {
  flush();
  if (temporary_.empty()) {
    close();
    return Durability::synced;
  }
  sync();
  close();
  stop_if_given_up();
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("rename to", errno);
  forget_temporary();
  return sync_folder();
}

/// The new name must outlive a crash, too. From here on nothing can be taken back, so that nothing
/// may fail. A folder that cannot be opened or synced at all is as safe as it can be.
Durability OutputFile::sync_folder() const noexcept {
  const int folder =
      ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NONBLOCK);
  if (folder < 0) return Durability::synced;
  int result = 0;
  do {
    result = ::fsync(folder);
  } while (result != 0 && errno == EINTR);
  const bool failed = result != 0 && !cannot_sync(errno);
  ::close(folder);
  return failed ? Durability::name_not_synced : Durability::synced;
}

void OutputFile::discard() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  forget_temporary();
}

void OutputFile::forget_temporary() noexcept {
  exposed_temporary = nullptr;
  temporary_.clear();
}

std::string OutputFile::name() const {
  return path_ == "-" ? "standard output" : visible(path_);
}

void remove_temporary_in_handler() noexcept {
  const char* const temporary = exposed_temporary;
  if (temporary != nullptr) ::unlink(temporary);
}

void OutputFile::fail(std::string_view action, int error) const {
  throw Error(ErrorCode::output_failed,
              fmt::format("{}: cannot {} it ({}); choose another place or free some room", name(),
                          action, std::generic_category().message(error)));
}

}  // namespace abut::io
