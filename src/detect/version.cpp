#include "base/lack_of_memory.hpp"

#include <abut/version.hpp>

#include <string>
#include <string_view>

#define ABUT_TEXT_OF(x) #x
#define ABUT_TEXT(x) ABUT_TEXT_OF(x)

namespace abut {
namespace {

constexpr std::string_view text = ABUT_TEXT(ABUT_VERSION_MAJOR) "." ABUT_TEXT(
    ABUT_VERSION_MINOR) "." ABUT_TEXT(ABUT_VERSION_PATCH);

#if defined(__clang__)
constexpr std::string_view compiler =
    "clang " ABUT_TEXT(__clang_major__) "." ABUT_TEXT(__clang_minor__);
#else
constexpr std::string_view compiler = "g++ " ABUT_TEXT(__GNUC__) "." ABUT_TEXT(__GNUC_MINOR__);
#endif

#if defined(__x86_64__)
constexpr std::string_view architecture = "x86-64";
#elif defined(__aarch64__)
constexpr std::string_view architecture = "aarch64";
#elif defined(__s390x__)
constexpr std::string_view architecture = "s390x";
#else
constexpr std::string_view architecture = "unknown architecture";
#endif

}  // namespace

std::string_view version() {
  return text;
}

std::string build_description() {
  return base::reporting_lack_of_memory([] {
    std::string description = "abut ";
    for (const std::string_view part :
         {text, std::string_view(" ("), compiler, std::string_view(", "), architecture,
          std::string_view(")")}) {
      description += part;
    }
    return description;
  });
}

}  // namespace abut
