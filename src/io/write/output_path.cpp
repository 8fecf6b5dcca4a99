#include "io/write/output_path.hpp"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <climits>
#include <string_view>
#include <system_error>

namespace abut::io {

std::string followed(const std::string& path) {
  constexpr int most_links = 40;
  std::string result = path;
  for (int k = 0; k < most_links; ++k) {
    char link[PATH_MAX];
    const ssize_t size = ::readlink(result.c_str(), link, sizeof link);
    if (size < 0) return result;  // no link, or nothing there
    const std::string_view next(link, static_cast<std::size_t>(size));
    result =
        next.starts_with('/') ? std::string(next) : folder_of(result) + '/' + std::string(next);
  }
  throw std::system_error(ELOOP, std::generic_category());
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

std::optional<int> named_descriptor(const std::string& path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view prefix : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(prefix)) continue;
    int descriptor = -1;
    const char* const last = path.data() + path.size();
    const auto [end, error] = std::from_chars(path.data() + prefix.size(), last, descriptor);
    if (error == std::errc() && end == last && descriptor >= 0) return descriptor;
  }
  return std::nullopt;
}

}  // namespace abut::io
